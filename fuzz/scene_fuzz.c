// SPDX-License-Identifier: MIT
// Scenes: any bytes, those written from known values, and such a one damaged.
#include "fuzz.h"
#include "scene_known.h"
#include <string.h>

/** A few bytes changed: of a scene that nearly is one. */
static void damage(scene_text *t, stream *s)
{
    static const char bytes[] =
        " \n\r\t:,-[]{}'\"#&*!|>%@.0123456789einfax~?\xc3";
    for (int n = stream_int(s, 1, 4); n > 0; n--)
        t->byte[stream_word(s, 2) % t->size] =
            bytes[stream_int(s, 0, (int)sizeof bytes - 2)];
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static scene_text t;
    stream s = stream_of_bytes(data, size);
    // What begins as scenes do is one.
    if (size > 0 && memchr("\nabdoprst#{-'\"\xef", data[0], 16)) {
        t.size = size < SCENE_TEXT_LONGEST ? size : SCENE_TEXT_LONGEST;
        memcpy(t.byte, data, t.size);
    } else {
        scene_known_check(&s, &t);
        damage(&t, &s);
    }
    scene_take(&t, 0);
    return 0;
}
