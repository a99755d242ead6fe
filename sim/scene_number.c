// SPDX-License-Identifier: MIT
#include "scene_number.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DIGITS "0123456789"

// [sign] digits [. digits] [e [sign] digits], with a digit before or after the
// point.
static int is_decimal(const char *text)
{
    const char *p = text + (*text == '+' || *text == '-');
    const size_t whole = strspn(p, DIGITS);
    if (whole > 1 && *p == '0')
        return 0; // octal to some, decimal to others
    p += whole;
    size_t fraction = 0;
    if (*p == '.') {
        fraction = strspn(++p, DIGITS);
        p += fraction;
    }
    if (whole + fraction == 0)
        return 0;
    if (*p == 'e' || *p == 'E') {
        p++;
        p += *p == '+' || *p == '-';
        const size_t exponent = strspn(p, DIGITS);
        if (exponent == 0)
            return 0;
        p += exponent;
    }
    return *p == '\0';
}

int brink_number_read(const char *text, double *value)
{
    if (!is_decimal(text))
        return 0;
    const double v = strtod(text, NULL);
    const char *significand = text + strspn(text, "+-0.");
    const int is_zero = strspn(significand, DIGITS) == 0;
    if (isinf(v) || (v == 0.0 && !is_zero))
        return -1;
    *value = v;
    return 1;
}

int brink_integer_read(const char *text, uint64_t *value)
{
    const size_t length = strspn(text, DIGITS);
    if (length == 0 || text[length] != '\0' || (length > 1 && *text == '0'))
        return 0;
    uint64_t n = 0;
    for (const char *p = text; *p; p++) {
        const uint64_t digit = (uint64_t)(*p - '0');
        if (n > (UINT64_MAX - digit) / 10)
            return -1;
        n = 10 * n + digit;
    }
    *value = n;
    return 1;
}
