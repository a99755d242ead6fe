// SPDX-License-Identifier: MIT
// Values written and read again; the bytes of the file and its seal against those
// of a few lines that need no table; and files damaged in every way.
#include "codec.h"
#include "fuzz.h"
#include <string.h>

enum { VALUES = 60, LARGEST = 4096, SEAL = 8 };

enum type { U32, U64, I64, INT, DOUBLE, BYTES, TYPES };

typedef struct script { // what is written, one after another
    int count;
    enum type type[VALUES];
    uint64_t value[VALUES]; // its bits; of bytes how many
    unsigned char bytes[256];
} script;

typedef struct image {
    size_t size;
    unsigned char byte[LARGEST];
} image;

static void broken(const script *p, const char *law)
{
    FINDING("codec: %s", law);
    fputs("  const struct { int type; uint64_t value; } script[] = {", stderr);
    for (int n = 0; n < p->count; n++)
        fprintf(stderr, "{%d, 0x%llx}, ", p->type[n],
                (unsigned long long)p->value[n]);
    fputs("};\n", stderr);
    finding_end();
}

static void make(script *p, stream *s)
{
    p->count = stream_int(s, 0, VALUES);
    for (int k = 0; k < (int)sizeof p->bytes; k++)
        p->bytes[k] = (unsigned char)(k * 7 + 1);
    for (int n = 0; n < p->count; n++) {
        p->type[n] = (enum type)stream_int(s, 0, TYPES - 1);
        p->value[n] =
            p->type[n] == BYTES ? (uint64_t)stream_int(s, 0, 40) : stream_bits(s);
        if (p->type[n] == U32 || p->type[n] == INT)
            p->value[n] &= UINT32_MAX;
    }
}

/** One value through the codec: what is read, or what was written. */
static uint64_t code(brink_codec *c, enum type type, uint64_t value,
                     unsigned char *bytes)
{
    uint32_t u32 = (uint32_t)value;
    int64_t i64 = (int64_t)value;
    int i = (int)u32;
    double x;
    memcpy(&x, &value, sizeof x);
    switch (type) {
    case U32:
        brink_code_u32(c, &u32);
        return u32;
    case U64:
        brink_code_u64(c, &value);
        return value;
    case I64:
        brink_code_i64(c, &i64);
        return (uint64_t)i64;
    case INT:
        brink_code_int(c, &i);
        return (uint32_t)i;
    case DOUBLE:
        brink_code_double(c, &x);
        memcpy(&value, &x, sizeof value);
        return value;
    default:
        brink_code_bytes(c, bytes, value);
        return value;
    }
}

static void write_script(const script *p, image *f)
{
    memset(f, 0, sizeof *f);
    FILE *file = fmemopen(f->byte, sizeof f->byte, "w");
    brink_codec c;
    unsigned char bytes[sizeof p->bytes];
    memcpy(bytes, p->bytes, sizeof bytes);
    brink_codec_write_to(&c, file);
    for (int n = 0; n < p->count; n++)
        code(&c, p->type[n], p->value[n], bytes);
    brink_codec_seal(&c);
    if (c.fault)
        broken(p, c.fault);
    f->size = (size_t)ftell(file);
    fclose(file);
}

/** CRC-64/XZ by its definition, a bit at a time. */
static uint64_t seal_of(const unsigned char *byte, size_t size)
{
    uint64_t rest = UINT64_MAX;
    for (size_t k = 0; k < 8 * size; k++) {
        const uint64_t bit = byte[k / 8] >> k % 8 & 1;
        rest = rest >> 1 ^ ((rest ^ bit) & 1 ? UINT64_C(0xC96C5795D7870F42) : 0);
    }
    return ~rest;
}

static size_t put(unsigned char *to, uint64_t value, size_t bytes)
{
    for (size_t k = 0; k < bytes; k++)
        to[k] = (unsigned char)(value >> 8 * k);
    return bytes;
}

/** Little-endian, nothing in between, and the seal. */
static void expect_layout(const script *p, const image *got)
{
    image f = {0};
    for (int n = 0; n < p->count; n++) {
        const int narrow = p->type[n] == U32 || p->type[n] == INT;
        if (p->type[n] == BYTES) {
            memcpy(f.byte + f.size, p->bytes, p->value[n]);
            f.size += p->value[n];
        } else {
            f.size += put(f.byte + f.size, p->value[n], narrow ? 4 : 8);
        }
    }
    f.size += put(f.byte + f.size, seal_of(f.byte, f.size), SEAL);
    if (f.size != got->size || memcmp(f.byte, got->byte, f.size) != 0)
        broken(p, "the bytes are those of the values, and their checksum");
}

/** What is wrong with a file that is read by the script's first values: as many
 *  as it has, fewer or one more. */
static const char *read_script(const script *p, image *f, int values)
{
    FILE *file = fmemopen(f->byte, f->size ? f->size : 1, "r");
    brink_codec c;
    unsigned char bytes[sizeof p->bytes];
    brink_codec_read_from(&c, file);
    for (int n = 0; n < values && n < p->count; n++) {
        memset(bytes, 0, sizeof bytes);
        const int is_bytes = p->type[n] == BYTES;
        const uint64_t got =
            code(&c, p->type[n], is_bytes ? p->value[n] : 0, bytes);
        if (!c.fault && (got != p->value[n] ||
                         (is_bytes && memcmp(bytes, p->bytes, got) != 0)))
            broken(p, "a value is read as it was written");
    }
    uint32_t beyond = 0;
    if (values > p->count)
        brink_code_u32(&c, &beyond);
    brink_codec_seal(&c);
    brink_codec_close(&c);
    fclose(file);
    return c.fault;
}

static void said(const script *p, const char *fault, const char *word)
{
    if (!fault || !strstr(fault, word))
        broken(p, word);
}

/** A fuzzer that sees what the seal is compared with has put one into the middle:
 *  there a file may end. */
static void cut_short(const script *p, const image *whole, int size)
{
    image f = *whole;
    unsigned char seal[SEAL];
    f.size = (size_t)size;
    if (size >= SEAL) {
        put(seal, seal_of(f.byte, f.size - SEAL), SEAL);
        if (memcmp(seal, f.byte + f.size - SEAL, SEAL) == 0)
            return;
    }
    said(p, read_script(p, &f, p->count), size < SEAL ? "short" : "checksum");
}

/** Any error within 64 neighbouring bits is found: the checksum promises it. */
static void damage(const script *p, const image *whole, stream *s)
{
    image f = *whole;
    const int at = stream_int(s, 0, (int)whole->size - 1);
    const int left = (int)whole->size - at, most = left < 8 ? left : 8;
    unsigned char changed = 0;
    for (int k = stream_int(s, 1, most) - 1; k >= 0; k--) {
        const unsigned char by = (unsigned char)stream_word(s, 1);
        f.byte[at + k] ^= by;
        changed |= by;
    }
    if (changed)
        said(p, read_script(p, &f, p->count), "checksum");
    cut_short(p, whole, stream_int(s, 0, (int)whole->size - 1));
}

/** Rooms: what the rest of a file cannot hold is promised too much. */
static void rooms(const script *p, image *f, stream *s)
{
    FILE *file = fmemopen(f->byte, f->size, "r");
    brink_codec c;
    brink_codec_read_from(&c, file);
    const uint64_t left = c.left;
    const size_t size = (size_t)stream_int(s, 1, 64);
    const size_t stored = (size_t)stream_int(s, 1, 64);
    uint64_t count = (uint64_t)stream_int(s, 0, 100);
    if (stream_int(s, 0,
                   1)) // so many that the product is a small one, modulo 2^64
        count += UINT64_MAX / stored + 1;
    unsigned char *room = brink_code_room(&c, NULL, count, size, stored);
    const int fits = count <= left / stored;
    if (fits != (room != NULL) || fits != (c.fault == NULL))
        broken(p, "there is room for what a file can hold, and no more");
    for (uint64_t k = 0; room && k < count * size; k++)
        if (room[k]++ != 0)
            broken(p, "memory that was handed out is empty");
    brink_codec_close(&c);
    fclose(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static script p;
    static image f;
    stream s = stream_of_bytes(data, size);
    make(&p, &s);
    write_script(&p, &f);
    expect_layout(&p, &f);
    const char *fault = read_script(&p, &f, p.count);
    if (fault)
        broken(&p, fault);
    said(&p, read_script(&p, &f, p.count + 1), "too soon");
    const int takes =
        p.count > 0 && (p.type[p.count - 1] != BYTES || p.value[p.count - 1] > 0);
    if (takes)
        said(&p, read_script(&p, &f, p.count - 1), "after its end");
    damage(&p, &f, &s);
    rooms(&p, &f, &s);
    return 0;
}
