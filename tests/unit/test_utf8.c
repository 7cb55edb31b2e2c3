/* Printable UTF-8 by the tables of the Unicode standard. */
#include "config/utf8.h"
#include "suite.h"
#include <string.h>

static size_t good_bytes(const char *text) {
  return utf8_printable(text, strlen(text));
}

START_TEST(text_of_all_lengths_of_characters_is_printable) {
  static const char *const texts[] = {"",
                                      "plain text\twith\r\nline ends",
                                      "\xc3\xa9",
                                      "\xe2\x82\xac",
                                      "\xf0\x9f\x92\xa7",
                                      "\xef\xbf\xbd",
                                      "\xf4\x8f\xbf\xbd",
                                      "\xc2\xa0"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
    ck_assert_uint_eq(good_bytes(texts[i]), strlen(texts[i]));
}
END_TEST

START_TEST(what_is_not_printable_utf8_stops_the_count) {
  static const char *const bad[] = {
      "\x01",
      "\x1b[0m",
      "\x7f",
      "\xc2\x85", /* controls */
      "\x80",
      "\xff",
      "\xc3",
      "\xe2\x82", /* broken */
      "\xc0\xaf",
      "\xe0\x80\xaf",
      "\xf0\x80\x80\x80", /* longer than needed */
      "\xed\xa0\x80",
      "\xf4\x90\x80\x80",
      "\xf8\x88\x80\x80\x80", /* surrogate, too large */
      "\xe2\x80\xa8",
      "\xef\xbb\xbf",
      "\xef\xbf\xbf",
      "\xc3\x28", /* line end, mark, not a character */
  };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    char text[16] = "ab";
    strcat(text, bad[i]);
    ck_assert_msg(good_bytes(text) == 2, "entry %zu", i);
  }
  ck_assert_uint_eq(utf8_printable("a\0b", 3), 1);
}
END_TEST

START_TEST(cutting_keeps_characters_whole_and_stops_at_line_ends) {
  ck_assert_uint_eq(utf8_cut("abc", 10), 3);
  ck_assert_uint_eq(utf8_cut("abcdef", 4), 4);
  ck_assert_uint_eq(utf8_cut("ab\xe2\x82\xac", 5), 5);
  ck_assert_uint_eq(utf8_cut("ab\xe2\x82\xac", 4), 2);
  ck_assert_uint_eq(utf8_cut("ab\ncd", 10), 2);
}
END_TEST

int main(void) {
  return suite_run("utf8", (SuiteTests){text_of_all_lengths_of_characters_is_printable,
                                        what_is_not_printable_utf8_stops_the_count,
                                        cutting_keeps_characters_whole_and_stops_at_line_ends, NULL});
}
