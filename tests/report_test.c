// SPDX-License-Identifier: MIT
#include "folder.h"
#include "report.h"
#include "suite.h"
#include <string.h>
#include <unistd.h>

// A page with one of everything, closed.
static int write_page(const char *folder, const char *text)
{
    static const char *const head[] = {"<name>", "number"};
    brink_report r;
    brink_report_open(&r, folder, text);
    brink_report_heading(&r, 2, "%s", text);
    brink_report_paragraph(&r, "%s", text);
    brink_report_finding(&r, "%s", text);
    brink_report_verbatim(&r, "%s", text);
    brink_report_table(&r, text, 2, "lr", head);
    brink_report_cell(&r, "%s", text);
    brink_report_cell(&r, "%d", 1);
    brink_report_cell(&r, "%s", text);
    brink_report_cell(&r, "%d", 2);
    brink_report_table_end(&r);
    brink_report_figure(&r, "one", text, "plot x\n");
    brink_report_figure(&r, "two", text, "plot -x\n");
    return brink_report_close(&r, stderr);
}

static int count(const char *text, const char *what)
{
    int n = 0;
    for (; (text = strstr(text, what)) != NULL; text++)
        n++;
    return n;
}

START_TEST(the_five_characters_are_escaped_and_no_other)
{
    char *written = NULL;
    size_t size;
    FILE *out = open_memstream(&written, &size);
    brink_report_escape(out, "<a href=\"b\">&'σ</a>");
    fclose(out);
    ck_assert_str_eq(written,
                     "&lt;a href=&quot;b&quot;&gt;&amp;&#39;σ&lt;/a&gt;");
    free(written);
}
END_TEST

START_TEST(no_text_becomes_markup)
{
    const char *folder = new_folder();
    ck_assert_int_eq(write_page(folder, "<script>alert('&')</script>"), 0);
    char *page = whole_file(folder, "index.html");
    ck_assert_int_eq(count(page, "<script"), 0);
    // title, heading, paragraph, finding, verbatim, caption, 2 cells, 2 figures
    ck_assert_int_eq(count(page, "&lt;script&gt;alert(&#39;&amp;&#39;)"), 10);
    ck_assert_int_eq(count(page, "&lt;name&gt;"), 1);
    free(page);
}
END_TEST

// What would make a browser fetch something: an address in an attribute that
// loads, or in a style sheet.  Names of XML namespaces are addresses too, and
// load nothing.
START_TEST(a_page_loads_nothing_from_anywhere)
{
    static const char *const loads[] = {
        "src=",  "@import", "<link",   "<script", "href='http", "href=\"http",
        "url(h", "url('h",  "url(\"h", "url(//",  "href=\"//",  "<iframe"};
    const char *folder = new_folder();
    ck_assert_int_eq(write_page(folder, "plain"), 0);
    char *page = whole_file(folder, "index.html");
    for (size_t k = 0; k < sizeof loads / sizeof loads[0]; k++)
        ck_assert_msg(strstr(page, loads[k]) == NULL, "the page has %s",
                      loads[k]);
    ck_assert_int_eq(count(page, "<svg"), 2);
    free(page);
}
END_TEST

START_TEST(cells_fall_into_rows_with_a_heading_each)
{
    const char *folder = new_folder();
    ck_assert_int_eq(write_page(folder, "plain"), 0);
    char *page = whole_file(folder, "index.html");
    ck_assert_ptr_nonnull(strstr(page,
                                 "<tr><th scope=\"row\" class=\"l\">plain</th>"
                                 "<td class=\"r\">1</td></tr>\n"
                                 "<tr><th scope=\"row\" class=\"l\">plain</th>"
                                 "<td class=\"r\">2</td></tr>\n</tbody>"));
    free(page);
}
END_TEST

START_TEST(a_page_that_failed_leaves_the_old_one_and_tells_why)
{
    const char *folder = new_folder();
    char *said = NULL;
    size_t size;
    write_file(folder, "index.html", "the old page");
    brink_report r;
    brink_report_open(&r, folder, "new");
    brink_report_figure(&r, "bad", "", "plot 'there-is-no-such.dat'\n");
    brink_report_figure(&r, "good", "", "plot x\n");
    brink_report_paragraph(&r, "more");
    FILE *errors = open_memstream(&said, &size);
    ck_assert_int_eq(brink_report_close(&r, errors), -1);
    fclose(errors);
    ck_assert_msg(strstr(said, "there-is-no-such.dat") != NULL, "%s", said);
    char *page = whole_file(folder, "index.html");
    ck_assert_str_eq(page, "the old page");
    ck_assert_int_ne(access(in_folder(folder, "index.html.part"), F_OK), 0);
    ck_assert_int_ne(access(in_folder(folder, "good.svg"), F_OK), 0);
    free(page);
    free(said);
}
END_TEST

START_TEST(a_folder_that_cannot_be_made_is_told)
{
    char *said = NULL;
    size_t size;
    FILE *errors = open_memstream(&said, &size);
    brink_report r;
    brink_report_open(&r, "/there/is/no/such", "page");
    brink_report_paragraph(&r, "%d", 1);
    ck_assert_int_eq(brink_report_close(&r, errors), -1);
    fclose(errors);
    ck_assert_msg(strstr(said, "/there/is/no/such") != NULL, "%s", said);
    free(said);
}
END_TEST

START_TEST(a_folder_that_is_missing_is_made)
{
    char path[200];
    snprintf(path, sizeof path, "%s/new", new_folder());
    ck_assert_int_eq(write_page(path, "plain"), 0);
    free(whole_file(path, "index.html"));
}
END_TEST

START_TEST(a_page_of_another_name_leaves_the_first_one_alone)
{
    const char *folder = new_folder();
    write_file(folder, "index.html", "the first page");
    brink_report r;
    brink_report_open_page(&r, folder, "second", "another page");
    ck_assert_int_eq(brink_report_close(&r, stderr), 0);
    char *first = whole_file(folder, "index.html");
    char *second = whole_file(folder, "second.html");
    ck_assert_str_eq(first, "the first page");
    ck_assert_ptr_nonnull(strstr(second, "<title>another page</title>"));
    free(first);
    free(second);
}
END_TEST

int main(void)
{
    return RUN_SUITE("report", 120, the_five_characters_are_escaped_and_no_other,
                     no_text_becomes_markup, a_page_loads_nothing_from_anywhere,
                     cells_fall_into_rows_with_a_heading_each,
                     a_page_that_failed_leaves_the_old_one_and_tells_why,
                     a_folder_that_cannot_be_made_is_told,
                     a_folder_that_is_missing_is_made,
                     a_page_of_another_name_leaves_the_first_one_alone);
}
