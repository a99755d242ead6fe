// SPDX-License-Identifier: MIT
#ifndef BRINK_CODEC_H
#define BRINK_CODEC_H
/**
 * Values to and from a file, little-endian, sealed by a checksum.  A codec works
 * in one direction: it writes the values it is shown, or reads into them, so that
 * one description of a layout serves both.  After the first fault it does nothing
 * more and leaves values as they are.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct brink_codec {
    FILE *file;
    int reading;
    uint64_t left; // reading: bytes of the body still to come
    uint64_t crc;  // writing: CRC-64/XZ of what was written
    uint64_t table[256];
    const char *fault; // NULL, or what is wrong
    void *rooms;       // memory handed out by brink_code_room
} brink_codec;

void brink_codec_write_to(brink_codec *c, FILE *file);

/** Checks the whole file against its seal, then stands at its beginning. */
void brink_codec_read_from(brink_codec *c, FILE *file);

/** Writing: appends the seal and flushes.  Reading: a body that goes on is a
 * fault. */
void brink_codec_seal(brink_codec *c);

/** Frees what brink_code_room handed out. */
void brink_codec_close(brink_codec *c);

void brink_code_bytes(brink_codec *c, void *bytes, uint64_t count);
void brink_code_u32(brink_codec *c, uint32_t *value);
void brink_code_u64(brink_codec *c, uint64_t *value);
void brink_code_i64(brink_codec *c, int64_t *value);
void brink_code_int(brink_codec *c, int *value);       // as 32 bits
void brink_code_double(brink_codec *c, double *value); // its bits

/** Room for `count` values that take at least `stored` bytes each in the file:
 * `there` when writing; when reading, zeroed memory of `size` bytes each, the
 * codec's own.  A count that the rest of the file cannot hold is a fault; NULL
 * then. */
void *brink_code_room(brink_codec *c, void *there, uint64_t count, size_t size,
                      size_t stored);
#endif
