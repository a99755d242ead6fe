// SPDX-License-Identifier: MIT
#include "codec.h"
#include <stdlib.h>
#include <string.h>

#define SEAL 8 // bytes of the checksum at the end

// CRC-64/XZ (ECMA-182 reflected): finds every error of up to 64 neighbouring
// bits.
static uint64_t crc_of(const brink_codec *c, uint64_t crc,
                       const unsigned char *bytes, size_t count)
{
    for (size_t k = 0; k < count; k++)
        crc = c->table[(crc ^ bytes[k]) & 0xff] ^ (crc >> 8);
    return crc;
}

static void open_codec(brink_codec *c, FILE *file, int reading)
{
    memset(c, 0, sizeof *c);
    c->file = file;
    c->reading = reading;
    c->crc = UINT64_MAX;
    for (uint64_t byte = 0; byte < 256; byte++) {
        uint64_t rest = byte;
        for (int bit = 0; bit < 8; bit++)
            rest = (rest >> 1) ^ (rest & 1 ? UINT64_C(0xC96C5795D7870F42) : 0);
        c->table[byte] = rest;
    }
}

void brink_codec_write_to(brink_codec *c, FILE *file)
{
    open_codec(c, file, 0);
}

void brink_codec_read_from(brink_codec *c, FILE *file)
{
    open_codec(c, file, 1);
    unsigned char block[4096 + SEAL];
    size_t held = 0, got;
    // The last SEAL bytes seen are held back: they may be the seal.
    while ((got = fread(block + held, 1, sizeof block - held, file)) > 0) {
        held += got;
        if (held <= SEAL)
            continue;
        c->crc = crc_of(c, c->crc, block, held - SEAL);
        c->left += held - SEAL;
        memmove(block, block + held - SEAL, SEAL);
        held = SEAL;
    }
    uint64_t seal = 0;
    for (int k = 0; k < SEAL; k++)
        seal |= (uint64_t)block[k] << 8 * k;
    if (ferror(file) || fseek(file, 0, SEEK_SET))
        c->fault = "it cannot be read";
    else if (held < SEAL)
        c->fault = "it is too short to be one";
    else if (seal != ~c->crc)
        c->fault = "its checksum is wrong: it was cut short or damaged";
}

void brink_codec_seal(brink_codec *c)
{
    if (c->reading && c->left > 0 && !c->fault)
        c->fault = "it goes on after its end";
    if (c->reading)
        return;
    uint64_t seal = ~c->crc;
    brink_code_u64(c, &seal);
    if (!c->fault && fflush(c->file))
        c->fault = "it cannot be written";
}

void brink_codec_close(brink_codec *c)
{
    while (c->rooms) {
        void *room = c->rooms;
        memcpy(&c->rooms, room, sizeof c->rooms);
        free(room);
    }
}

static void move(brink_codec *c, unsigned char *bytes, size_t count)
{
    if (c->fault || count == 0) // of nothing there need not be an address
        return;
    if (!c->reading) {
        c->crc = crc_of(c, c->crc, bytes, count);
        if (fwrite(bytes, 1, count, c->file) != count)
            c->fault = "it cannot be written";
    } else if (count > c->left) {
        c->fault = "it ends too soon";
    } else {
        c->left -= count;
        if (fread(bytes, 1, count, c->file) != count)
            c->fault = "it cannot be read";
    }
}

void brink_code_bytes(brink_codec *c, void *bytes, uint64_t count)
{
    move(c, bytes, (size_t)count);
}

// An unsigned value in its first `width` bytes, lowest first.
static uint64_t code_unsigned(brink_codec *c, uint64_t value, size_t width)
{
    unsigned char bytes[8];
    for (size_t k = 0; k < width; k++)
        bytes[k] = (unsigned char)(value >> 8 * k);
    move(c, bytes, width);
    uint64_t coded = 0;
    for (size_t k = 0; k < width; k++)
        coded |= (uint64_t)bytes[k] << 8 * k;
    return coded;
}

void brink_code_u32(brink_codec *c, uint32_t *value)
{
    *value = (uint32_t)code_unsigned(c, *value, 4);
}

void brink_code_u64(brink_codec *c, uint64_t *value)
{
    *value = code_unsigned(c, *value, 8);
}

void brink_code_i64(brink_codec *c, int64_t *value)
{
    *value = (int64_t)code_unsigned(c, (uint64_t)*value, 8);
}

void brink_code_int(brink_codec *c, int *value)
{
    *value = (int)(int32_t)code_unsigned(c, (uint32_t)*value, 4);
}

void brink_code_double(brink_codec *c, double *value)
{
    uint64_t bits;
    memcpy(&bits, value, sizeof bits);
    bits = code_unsigned(c, bits, 8);
    memcpy(value, &bits, sizeof bits);
}

void *brink_code_room(brink_codec *c, void *there, uint64_t count, size_t size,
                      size_t stored)
{
    if (!c->reading || c->fault)
        return c->fault ? NULL : there;
    if (count > c->left / stored) {
        c->fault = "it promises more than it holds";
        return NULL;
    }
    // In front, aligned for anything, the link to the room before.
    const size_t head = _Alignof(max_align_t);
    char *room = calloc(1, head + (size_t)count * size);
    if (!room) {
        c->fault = "memory is out";
        return NULL;
    }
    memcpy(room, &c->rooms, sizeof c->rooms);
    c->rooms = room;
    return room + head;
}
