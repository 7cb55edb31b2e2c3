/* The JSON writer against the grammar of RFC 8259, by whole documents. */
#include "observe/json.h"

#include "suite.h"
#include <math.h>
#include <string.h>

static Text text;
static Error error;
static Json json;

static void begin(void) {
  text_free(&text);
  json_begin(&json, &text, &error);
}

static void ends_as(const char *expected) {
  ck_assert_int_eq(json_end(&json), STATUS_OK);
  ck_assert_str_eq(text.data, expected);
}

START_TEST(values_of_every_kind_stand_in_order) {
  begin();
  json_open_object(&json, NULL);
  json_number(&json, "number", 0.05);
  json_integer(&json, "integer", -9007199254740993LL);
  json_string(&json, "string", "text");
  json_boolean(&json, "yes", true);
  json_boolean(&json, "no", false);
  json_null(&json, "nothing");
  json_string(&json, "no string", NULL);
  json_numbers(&json, "numbers", (const double[]){1, -2.5, 3e100}, 3);
  json_open_array(&json, "array");
  json_integer(&json, NULL, 1);
  json_open_object(&json, NULL);
  json_close(&json);
  json_close(&json);
  json_close(&json);
  ends_as("{\n"
          "  \"number\": 0.05,\n"
          "  \"integer\": -9007199254740993,\n"
          "  \"string\": \"text\",\n"
          "  \"yes\": true,\n"
          "  \"no\": false,\n"
          "  \"nothing\": null,\n"
          "  \"no string\": null,\n"
          "  \"numbers\": [1, -2.5, 3e+100],\n"
          "  \"array\": [\n"
          "    1,\n"
          "    {}\n"
          "  ]\n"
          "}\n");
}
END_TEST

START_TEST(what_is_not_finite_is_null) {
  begin();
  json_numbers(&json, NULL, (const double[]){NAN, INFINITY, -INFINITY}, 3);
  ends_as("[null, null, null]\n");
  begin();
  json_number(&json, NULL, NAN);
  ends_as("null\n");
}
END_TEST

START_TEST(strings_and_keys_are_escaped) {
  begin();
  json_open_object(&json, NULL);
  json_string(&json, "a \"key\"", "quote \" backslash \\ newline \n tab \t bell \a");
  json_close(&json);
  ends_as("{\n  \"a \\\"key\\\"\": "
          "\"quote \\\" backslash \\\\ newline \\u000a tab \\u0009 bell \\u0007\"\n}\n");
}
END_TEST

START_TEST(utf8_is_kept_and_what_is_not_utf8_is_replaced) {
  begin();
  json_string(&json, NULL, "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x99\x82");
  ends_as("\"caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x99\x82\"\n");
  const char *const bad[] = {
      "\xff",            /* never a first byte */
      "\x80",            /* a continuation alone */
      "\xc3",            /* cut off */
      "\xc0\xaf",        /* overlong '/' */
      "\xed\xa0\x80",    /* surrogate */
      "\xf4\x90\x80\x80" /* beyond U+10FFFF */
  };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    begin();
    json_string(&json, NULL, bad[k]);
    ck_assert_int_eq(json_end(&json), STATUS_OK);
    ck_assert_ptr_nonnull(strstr(text.data, "\xef\xbf\xbd"));
    ck_assert_ptr_null(strchr(text.data, bad[k][0]));
  }
}
END_TEST

START_TEST(objects_left_open_or_closed_twice_are_told) {
  begin();
  json_open_object(&json, NULL);
  ck_assert_int_eq(json_end(&json), STATUS_FAILED);
  begin();
  json_close(&json);
  ck_assert_int_eq(json_end(&json), STATUS_FAILED);
  begin();
  for (int level = 0; level <= JSON_MAX_DEPTH; level++) json_open_array(&json, NULL);
  ck_assert_int_eq(json_end(&json), STATUS_FAILED);
}
END_TEST

/* The vectors of RFC 4648, section 10. */
START_TEST(bytes_are_base64) {
  static const char *const vectors[][2] = {{"", "\"\"\n"},
                                           {"f", "\"Zg==\"\n"},
                                           {"fo", "\"Zm8=\"\n"},
                                           {"foo", "\"Zm9v\"\n"},
                                           {"foob", "\"Zm9vYg==\"\n"},
                                           {"fooba", "\"Zm9vYmE=\"\n"},
                                           {"foobar", "\"Zm9vYmFy\"\n"}};
  for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++) {
    begin();
    json_bytes(&json, NULL, (const unsigned char *)vectors[k][0], strlen(vectors[k][0]));
    ends_as(vectors[k][1]);
  }
}
END_TEST

START_TEST(many_bytes_lose_none) {
  enum { N = 10000 };
  static unsigned char zeros[N]; /* three zero bytes are "AAAA" */
  begin();
  json_bytes(&json, NULL, zeros, N);
  ck_assert_int_eq(json_end(&json), STATUS_OK);
  ck_assert_uint_eq(strspn(text.data + 1, "A"), 4 * (N / 3) + 2);
  ck_assert_str_eq(text.data + 1 + 4 * (N / 3) + 2, "==\"\n");
}
END_TEST

START_TEST(a_document_can_hold_another) {
  begin();
  json_open_object(&json, NULL);
  json_raw(&json, "other", "{\"a\": 1}");
  json_integer(&json, "next", 2);
  json_close(&json);
  ends_as("{\n  \"other\": {\"a\": 1},\n  \"next\": 2\n}\n");
}
END_TEST

int main(void) {
  return suite_run("json",
                   (SuiteTests){values_of_every_kind_stand_in_order, what_is_not_finite_is_null,
                                strings_and_keys_are_escaped, utf8_is_kept_and_what_is_not_utf8_is_replaced,
                                objects_left_open_or_closed_twice_are_told, bytes_are_base64,
                                many_bytes_lose_none, a_document_can_hold_another, NULL});
}
