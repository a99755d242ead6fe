// SPDX-License-Identifier: MIT
// Snapshots: whole ones, damaged ones, damaged ones with a checksum that fits,
// and any bytes.  Each is refused, or a valid run that is written to the same
// bytes.
#include "adverse.h"
#include "codec.h"
#include "fuzz.h"
#include "snapshot.h"
#include <stdlib.h>
#include <string.h>

enum { SEAL = 8, EVENTS = 20, FURTHER = 300 };

typedef struct bytes {
    char *byte;
    size_t size;
} bytes;

static _Noreturn void broken(const bytes *b, const char *law)
{
    FINDING("snapshot: %s", law);
    fputs("  const unsigned char bytes[] = {", stderr);
    for (size_t k = 0; k < b->size; k++)
        fprintf(stderr, "%s0x%02x,", k % 16 ? " " : "\n    ",
                (unsigned)(unsigned char)b->byte[k]);
    fputs("\n  };\n", stderr);
    finding_end();
}

static bytes write_run(const brink_run *run, const brink_plan *plan)
{
    bytes b = {0};
    FILE *file = open_memstream(&b.byte, &b.size);
    const char *fault = brink_snapshot_write(file, run, plan);
    fclose(file);
    if (fault)
        broken(&b, fault);
    return b;
}

static const char *read_run(const bytes *b, brink_run *run, brink_plan *plan)
{
    static const brink_run none;
    // The last argument of fmemopen may not be 0 everywhere.
    FILE *file = fmemopen(b->byte, b->size ? b->size : 1, "r");
    const char *fault = brink_snapshot_read(file, run, plan);
    fclose(file);
    if (fault && (run->system.particle || run->calendar.entry || plan->scene ||
                  plan->record || run->system.count != none.system.count))
        broken(b, "what is refused leaves nothing");
    return fault;
}

/** What a snapshot says of itself is not taken on trust: it goes on, whatever it
 *  comes to, for a while and within the memory there is. */
static void go_on(brink_run *run)
{
    for (int n = 0; n < FURTHER && brink_run_step(run) == BRINK_RUN_REACHED; n++)
        continue;
}

/** A valid run; and written, read and written the same bytes. */
static void take(const bytes *b)
{
    brink_run run, again;
    brink_plan plan, replan;
    if (read_run(b, &run, &plan))
        return;
    if (brink_run_is_valid(&run))
        broken(b, "what is taken is valid");
    bytes once = write_run(&run, &plan);
    if (read_run(&once, &again, &replan))
        broken(b, "what is written is taken");
    bytes twice = write_run(&again, &replan);
    if (once.size != twice.size || memcmp(once.byte, twice.byte, once.size) != 0)
        broken(b, "what is read is written to the same bytes");
    free(once.byte);
    free(twice.byte);
    go_on(&again);
    brink_run_destroy(&run);
    brink_run_destroy(&again);
    brink_plan_destroy(&plan);
    brink_plan_destroy(&replan);
}

/** A seal that fits. */
static bytes seal(const bytes *body)
{
    bytes b = {0};
    FILE *file = open_memstream(&b.byte, &b.size);
    brink_codec c;
    brink_codec_write_to(&c, file);
    brink_code_bytes(&c, body->byte, body->size);
    brink_codec_seal(&c);
    fclose(file);
    return b;
}

/** A number as a file may have it that is meant to do harm. */
static uint64_t make_number(stream *s)
{
    static const double reals[] = {
        0, -1, 1e300, 0x1p-1074, (double)INFINITY, (double)NAN};
    uint64_t word = 0;
    switch (stream_int(s, 0, 4)) {
    case 0:
        return (uint64_t)(int64_t)stream_int(s, -2, 20);
    case 1:
        return UINT64_C(1) << stream_int(s, 0, 63);
    case 2:
        memcpy(&word, &reals[stream_int(s, 0, 5)], sizeof word);
        return word;
    case 3:
        return UINT64_MAX >> stream_int(s, 0, 40);
    default:
        return stream_bits(s);
    }
}

/** Changes the body: a byte, a number, a piece out or twice, the end off. */
static void forge(bytes *b, stream *s)
{
    const size_t at = stream_word(s, 2) % b->size;
    const size_t left = b->size - at, piece = left < 8 ? left : 8;
    switch (stream_int(s, 0, 5)) {
    case 0:
        b->byte[at] = (char)stream_word(s, 1);
        break;
    case 1:
    case 2: { // whole numbers are at multiples of four
        const uint64_t number = make_number(s);
        const size_t four = at / 4 * 4;
        const size_t room = b->size - four, size = stream_int(s, 0, 1) ? 4 : 8;
        memcpy(b->byte + four, &number, room < size ? room : size);
        break;
    }
    case 3:
        b->byte[at] ^= (char)(1 << stream_int(s, 0, 7));
        break;
    case 4:
        memmove(b->byte + at, b->byte + at + piece, left - piece);
        b->size -= b->size > piece ? piece : 0;
        break;
    default:
        b->size = at + 1;
        break;
    }
}

static void forged(const bytes *whole, stream *s)
{
    bytes body = {malloc(whole->size), whole->size - SEAL};
    memcpy(body.byte, whole->byte, body.size);
    for (int n = stream_int(s, 1, 3); n > 0; n--)
        forge(&body, s);
    const bytes b = seal(&body);
    take(&b);
    free(body.byte);
    free(b.byte);
}

/** With a seal that does not fit any more, it is refused for that. */
static void damaged(const bytes *whole, stream *s)
{
    bytes b = {malloc(whole->size), whole->size};
    brink_run run;
    brink_plan plan;
    memcpy(b.byte, whole->byte, b.size);
    const size_t at = stream_word(s, 2) % b.size;
    b.byte[at] ^= (char)(1 << stream_int(s, 0, 7));
    const char *fault = read_run(&b, &run, &plan);
    if (!fault || !strstr(fault, "checksum"))
        broken(&b, "a damaged one is refused for its checksum");
    b.byte[at] = whole->byte[at];
    b.size = stream_word(s, 2) % whole->size;
    fault = read_run(&b, &run, &plan);
    if (!fault)
        broken(&b, "one that was cut short is refused");
    free(b.byte);
}

static void make_run(stream *s, brink_run *run)
{
    brink_system system;
    adverse_make(s, &system);
    system.year *= 0x1p-4; // it has years behind it
    LAW(brink_run_create(run, &system, BRINK_TIER_PLAIN) == 0,
        "snapshot: memory is out");
    const int events = stream_int(s, 0, EVENTS);
    const brink_instant until =
        brink_instant_after(run->system.year, run->now, 32 * run->system.year);
    brink_run_advance(run, (uint64_t)events, until);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static char scene[] = "a scene", record[] = "what was seen";
    stream s = stream_of_bytes(data, size);
    const brink_plan plan = {.events = stream_word(&s, 1),
                             .until = 2,
                             .scene = scene,
                             .scene_size = sizeof scene - 1,
                             .record = record,
                             .record_size = sizeof record - 1};
    if (stream_int(&s, 0, 7) == 0) { // the bytes themselves, sealed or not
        bytes raw = {malloc(s.left + 1), s.left};
        memcpy(raw.byte, s.bytes, s.left);
        const bytes b = seal(&raw);
        take(&raw);
        take(&b);
        free(raw.byte);
        free(b.byte);
        return 0;
    }
    brink_run run;
    make_run(&s, &run);
    const bytes whole = write_run(&run, &plan);
    brink_run read;
    brink_plan replan;
    if (read_run(&whole, &read, &replan))
        broken(&whole, "what is written is taken");
    const bytes again = write_run(&read, &replan);
    if (again.size != whole.size ||
        memcmp(again.byte, whole.byte, whole.size) != 0)
        broken(&whole, "what was written is read, every bit");
    brink_run_destroy(&read);
    brink_plan_destroy(&replan);
    damaged(&whole, &s);
    for (int n = stream_int(&s, 1, 4); n > 0; n--)
        forged(&whole, &s);
    free(whole.byte);
    free(again.byte);
    brink_run_destroy(&run);
    return 0;
}
