// SPDX-License-Identifier: MIT
#include "codec.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct sample {
    uint32_t a;
    uint64_t b;
    int64_t c;
    int d;
    double e;
    char text[5];
} sample;

static void code(brink_codec *c, sample *s)
{
    brink_code_u32(c, &s->a);
    brink_code_u64(c, &s->b);
    brink_code_i64(c, &s->c);
    brink_code_int(c, &s->d);
    brink_code_double(c, &s->e);
    brink_code_bytes(c, s->text, sizeof s->text);
    brink_codec_seal(c);
}

static const sample written = {0xdeadbeef, UINT64_MAX - 1, INT64_MIN,
                               -7,         -0.0,           "text"};

static FILE *write_sample(void)
{
    FILE *file = tmpfile();
    sample s = written;
    brink_codec c;
    brink_codec_write_to(&c, file);
    code(&c, &s);
    ck_assert_ptr_null(c.fault);
    rewind(file);
    return file;
}

static const char *read_sample(FILE *file, sample *s)
{
    brink_codec c;
    rewind(file);
    brink_codec_read_from(&c, file);
    code(&c, s);
    brink_codec_close(&c);
    return c.fault;
}

START_TEST(what_is_written_is_read_to_the_bit)
{
    FILE *file = write_sample();
    sample s = {0};
    ck_assert_ptr_null(read_sample(file, &s));
    ck_assert(s.a == written.a && s.b == written.b && s.c == written.c &&
              s.d == written.d && s.e == 0 && signbit(s.e) &&
              memcmp(s.text, written.text, 5) == 0);
    fclose(file);
}
END_TEST

START_TEST(bytes_are_little_endian_and_the_checksum_is_crc_64_xz)
{
    FILE *file = tmpfile();
    brink_codec c;
    char text[] = "123456789";
    brink_codec_write_to(&c, file);
    brink_code_bytes(&c, text, 9);
    ck_assert_uint_eq(~c.crc,
                      UINT64_C(0x995DC9BBDF1939FA)); // the published check value
    uint32_t value = 0x01020304;
    brink_code_u32(&c, &value);
    rewind(file);
    unsigned char bytes[13];
    ck_assert_uint_eq(fread(bytes, 1, 13, file), 13);
    ck_assert_mem_eq(bytes + 9, ((unsigned char[]){4, 3, 2, 1}), 4);
    fclose(file);
}
END_TEST

START_TEST(every_single_bit_counts)
{
    FILE *file = write_sample();
    fseek(file, 0, SEEK_END);
    const long size = ftell(file);
    for (long bit = 0; bit < 8 * size; bit++) {
        sample s;
        fseek(file, bit / 8, SEEK_SET);
        const int byte = fgetc(file);
        fseek(file, bit / 8, SEEK_SET);
        fputc(byte ^ 1 << bit % 8, file);
        ck_assert_msg(read_sample(file, &s) != NULL, "bit %ld", bit);
        fseek(file, bit / 8, SEEK_SET);
        fputc(byte, file);
    }
    fclose(file);
}
END_TEST

START_TEST(a_file_cut_short_anywhere_is_a_fault)
{
    unsigned char bytes[100];
    FILE *file = write_sample();
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    for (size_t left = 0; left < size; left++) {
        sample s;
        file = tmpfile();
        fwrite(bytes, 1, left, file);
        ck_assert_msg(read_sample(file, &s) != NULL, "%zu bytes", left);
        fclose(file);
    }
}
END_TEST

START_TEST(a_body_longer_or_shorter_than_what_is_read_is_a_fault)
{
    FILE *file = write_sample();
    brink_codec c;
    uint32_t value;
    brink_codec_read_from(&c, file);
    brink_code_u32(&c, &value);
    brink_codec_seal(&c);
    ck_assert_ptr_nonnull(strstr(c.fault, "goes on"));
    uint64_t more[9];
    rewind(file);
    brink_codec_read_from(&c, file);
    brink_code_bytes(&c, more, sizeof more);
    ck_assert_ptr_nonnull(strstr(c.fault, "too soon"));
    fclose(file);
}
END_TEST

START_TEST(room_is_never_made_for_more_than_the_file_holds)
{
    FILE *file = write_sample();
    brink_codec c;
    brink_codec_read_from(&c, file);
    ck_assert_ptr_nonnull(brink_code_room(&c, NULL, 3, 8, 8));
    ck_assert_ptr_null(brink_code_room(&c, NULL, UINT64_MAX / 2, 8, 8));
    ck_assert_ptr_nonnull(strstr(c.fault, "promises"));
    brink_codec_close(&c);
    fclose(file);
}
END_TEST

int main(void)
{
    return RUN_SUITE("codec", 60, what_is_written_is_read_to_the_bit,
                     bytes_are_little_endian_and_the_checksum_is_crc_64_xz,
                     every_single_bit_counts,
                     a_file_cut_short_anywhere_is_a_fault,
                     a_body_longer_or_shorter_than_what_is_read_is_a_fault,
                     room_is_never_made_for_more_than_the_file_holds);
}
