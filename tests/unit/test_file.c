/* Files are read whole, written whole or not at all, and hashed as FNV-1a says. */
#include "base/file.h"
#include "suite.h"
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/capsella-test-XXXXXX"; /* made anew for each run of this program */

static const char *in_folder(const char *name) {
  static Text path;
  Error error;
  text_free(&path);
  ck_assert_int_eq(file_join(&path, folder, name, &error), STATUS_OK);
  return path.data;
}

static int count_entries(void) {
  int count = 0;
  DIR *entries = opendir(folder);
  while (readdir(entries)) count++;
  closedir(entries);
  return count - 2; /* . and .. */
}

static void write_file(const char *name, const char *data, size_t length) {
  Error error;
  ck_assert_int_eq(file_write(in_folder(name), data, length, &error), STATUS_OK);
}

START_TEST(what_is_written_is_read_back) {
  Error error;
  Text text = {0};
  char data[10000];
  for (size_t i = 0; i < sizeof data; i++) data[i] = (char)(i * i % 251);
  write_file("data", data, sizeof data);
  ck_assert(file_exists(in_folder("data")));
  ck_assert_int_eq(file_read(in_folder("data"), sizeof data, &text, &error), STATUS_OK);
  ck_assert_uint_eq(text.length, sizeof data);
  ck_assert_mem_eq(text.data, data, sizeof data);
  text_free(&text);
}
END_TEST

START_TEST(an_empty_file_reads_as_an_empty_string) {
  Error error;
  Text text = {0};
  write_file("empty", "", 0);
  ck_assert_int_eq(file_read(in_folder("empty"), 10, &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, "");
  text_free(&text);
}
END_TEST

START_TEST(a_file_beyond_the_limit_is_refused) {
  Error error;
  Text text = {0};
  write_file("large", "0123456789", 10);
  ck_assert_int_eq(file_read(in_folder("large"), 9, &text, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "9 bytes"));
  text_free(&text);
}
END_TEST

START_TEST(missing_files_and_folders_are_named_errors) {
  Error error;
  Text text = {0};
  uint64_t hash;
  ck_assert(!file_exists(in_folder("nothing")));
  ck_assert(!file_exists(folder));
  ck_assert_int_eq(file_read(in_folder("nothing"), 10, &text, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "nothing"));
  ck_assert_int_eq(file_read(folder, 10, &text, &error), STATUS_IO);
  ck_assert_int_eq(file_hash(in_folder("nothing"), &hash, &error), STATUS_IO);
  ck_assert_int_eq(file_write(in_folder("no/such/folder"), "x", 1, &error), STATUS_IO);
  text_free(&text);
}
END_TEST

START_TEST(a_new_version_replaces_the_old_and_leaves_nothing_else) {
  Error error;
  Text text = {0};
  write_file("version", "old and longer", 14);
  int entries = count_entries();
  write_file("version", "new", 3);
  ck_assert_int_eq(count_entries(), entries);
  ck_assert_int_eq(file_read(in_folder("version"), 100, &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, "new");
  text_free(&text);
}
END_TEST

START_TEST(a_write_that_fails_leaves_no_temporary_file) {
  Error error;
  ck_assert_int_eq(mkdir(in_folder("taken"), 0777), 0);
  int entries = count_entries();
  ck_assert_int_eq(file_write(in_folder("taken"), "x", 1, &error), STATUS_IO);
  ck_assert_int_eq(count_entries(), entries);
}
END_TEST

START_TEST(a_finished_temporary_file_gets_its_final_name) {
  Error error;
  Text temporary = {0};
  ck_assert_int_eq(file_join(&temporary, folder, "snapshot.part", &error), STATUS_OK);
  write_file("snapshot.part", "whole", 5);
  ck_assert_int_eq(file_publish(temporary.data, in_folder("snapshot"), &error), STATUS_OK);
  ck_assert(file_exists(in_folder("snapshot")));
  ck_assert(!file_exists(temporary.data));
  text_free(&temporary);
}
END_TEST

START_TEST(folders_are_made_with_their_parents) {
  Error error;
  ck_assert_int_eq(file_make_folder(in_folder("a/b//c/"), &error), STATUS_OK);
  ck_assert_int_eq(file_make_folder(in_folder("a/b/c"), &error), STATUS_OK); /* again */
  write_file("a/b/c/file", "x", 1);
  ck_assert_int_eq(file_make_folder(in_folder("a/b/c/file/d"), &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "a/b/c/file"));
}
END_TEST

START_TEST(hashes_are_those_of_the_published_table) {
  /* draft-eastlake-fnv, test vectors for 64-bit FNV-1a */
  static const struct {
    const char *data;
    uint64_t hash;
  } table[] = {{"", 0xcbf29ce484222325}, {"a", 0xaf63dc4c8601ec8c}, {"foobar", 0x85944171f73967e8}};
  Error error;
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    uint64_t hash;
    write_file("hashed", table[i].data, strlen(table[i].data));
    ck_assert_int_eq(file_hash(in_folder("hashed"), &hash, &error), STATUS_OK);
    ck_assert_uint_eq(hash, table[i].hash);
  }
}
END_TEST

START_TEST(paths_join_and_part) {
  static const struct {
    const char *folder, *name, *joined;
  } joins[] = {{"out", "x", "out/x"}, {"out/", "x", "out/x"}, {"", "x", "x"},           {"out", "/x", "/x"},
               {"/", "x", "/x"},      {".", "./x", "./x"},    {"/out", "./x", "/out/x"}};
  static const struct {
    const char *path, *folder;
  } parts[] = {{"a/b/c", "a/b"}, {"c", "."}, {"/c", "/"}, {"a/", "a"}};
  Error error;
  for (size_t i = 0; i < sizeof joins / sizeof *joins; i++) {
    Text text = {0};
    ck_assert_int_eq(file_join(&text, joins[i].folder, joins[i].name, &error), STATUS_OK);
    ck_assert_str_eq(text.data, joins[i].joined);
    text_free(&text);
  }
  for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
    Text text = {0};
    ck_assert_int_eq(file_folder(&text, parts[i].path, &error), STATUS_OK);
    ck_assert_str_eq(text.data, parts[i].folder);
    text_free(&text);
  }
}
END_TEST

START_TEST(a_folder_goes_with_all_it_holds_and_nothing_that_it_links_to) {
  Error error;
  Text kept = {0}, link = {0};
  ck_assert_int_eq(file_make_folder(in_folder("kept"), &error), STATUS_OK);
  ck_assert_int_eq(file_write(in_folder("kept/file"), "x", 1, &error), STATUS_OK);
  ck_assert_int_eq(file_make_folder(in_folder("gone/deep"), &error), STATUS_OK);
  ck_assert_int_eq(file_write(in_folder("gone/deep/file"), "x", 1, &error), STATUS_OK);
  ck_assert_int_eq(file_join(&kept, folder, "kept", &error), STATUS_OK);
  ck_assert_int_eq(file_join(&link, folder, "gone/link", &error), STATUS_OK);
  ck_assert_int_eq(symlink(kept.data, link.data), 0);
  file_remove_folder(in_folder("gone"));
  ck_assert(file_exists(in_folder("kept/file")));
  ck_assert_int_ne(access(in_folder("gone"), F_OK), 0);
  text_free(&kept);
  text_free(&link);
}
END_TEST

int main(void) {
  if (!mkdtemp(folder)) return EXIT_FAILURE;
  int result = suite_run(
      "file",
      (SuiteTests){what_is_written_is_read_back, an_empty_file_reads_as_an_empty_string,
                   a_file_beyond_the_limit_is_refused, missing_files_and_folders_are_named_errors,
                   a_new_version_replaces_the_old_and_leaves_nothing_else,
                   a_write_that_fails_leaves_no_temporary_file, a_finished_temporary_file_gets_its_final_name,
                   folders_are_made_with_their_parents, hashes_are_those_of_the_published_table,
                   paths_join_and_part, a_folder_goes_with_all_it_holds_and_nothing_that_it_links_to, NULL});
  file_remove_folder(folder);
  return result;
}
