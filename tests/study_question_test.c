// SPDX-License-Identifier: MIT
#include "conventional_method.h"
#include "folder.h"
#include "study_question.h"
#include "suite.h"
#include <string.h>

START_TEST(every_way_is_named_and_explained)
{
    const char *folder = new_folder();
    brink_report r;
    brink_report_open(&r, folder, "question");
    brink_question_pose(&r);
    ck_assert_int_eq(brink_report_close(&r, stderr), 0);
    char *page = whole_file(folder, "index.html");
    for (int k = 0; k < BRINK_METHODS; k++) {
        const brink_rule *rule = brink_method_rule((enum brink_method)k);
        ck_assert_msg(strstr(page, rule->name) != NULL, "%s", rule->name);
        // of the idea: further on there may be something to escape
        char begin[20];
        snprintf(begin, sizeof begin, "%s", rule->idea);
        begin[strcspn(begin, "'")] = '\0';
        ck_assert_msg(strstr(page, begin) != NULL, "%s", begin);
    }
    ck_assert_ptr_nonnull(strstr(page, "1.0\u00a0×\u00a010⁻¹⁰"));
    free(page);
}
END_TEST

START_TEST(the_sketch_numbers_the_events_of_the_paper)
{
    static const char *const numbers[] = {">1<", ">2a<", ">2b<", ">3<"};
    const char *folder = new_folder();
    brink_report r;
    brink_report_open(&r, folder, "question");
    brink_question_pose(&r);
    ck_assert_int_eq(brink_report_close(&r, stderr), 0);
    char *page = whole_file(folder, "index.html");
    for (int k = 0; k < 4; k++)
        ck_assert_ptr_nonnull(strstr(page, numbers[k]));
    free(page);
}
END_TEST

int main(void)
{
    return RUN_SUITE("question", 60, every_way_is_named_and_explained,
                     the_sketch_numbers_the_events_of_the_paper);
}
