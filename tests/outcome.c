// SPDX-License-Identifier: MIT
#include "outcome.h"
#include "start.h"
#include <check.h>
#include <stdlib.h>
#include <string.h>

outcome parse_bytes(const char *text, size_t size)
{
    outcome o = {0};
    size_t length = 0;
    FILE *errors = open_memstream(&o.said, &length);
    o.complaints =
        brink_scene_parse(text, size, "t.yaml", "here", &o.scene, errors);
    fclose(errors);
    return o;
}

outcome parse(const char *text)
{
    return parse_bytes(text, strlen(text));
}

outcome start(const char *text)
{
    outcome o = {0};
    size_t length = 0;
    ck_assert_int_eq(
        brink_scene_parse(text, strlen(text), "t.yaml", "", &o.scene, stderr), 0);
    FILE *errors = open_memstream(&o.said, &length);
    o.status = brink_start_make(&o.scene, "t.yaml", &o.system, errors);
    fclose(errors);
    return o;
}

outcome good_start(const char *text)
{
    outcome o = start(text);
    ck_assert_msg(o.status == 0, "%s\n%s", text, o.said);
    const char *fault = brink_system_is_valid(&o.system);
    ck_assert_msg(fault == NULL, "%s\n%s", text, fault);
    return o;
}

void forget(outcome *o)
{
    brink_scene_destroy(&o->scene);
    brink_system_destroy(&o->system);
    free(o->said);
}
