// SPDX-License-Identifier: MIT
#include "study_words.h"
#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

brink_words brink_words_grouped(uint64_t n)
{
    char digits[32];
    brink_words w = {""};
    const int length = snprintf(digits, sizeof digits, "%" PRIu64, n);
    for (int k = 0, at = 0; k < length; k++)
        at += snprintf(w.text + at, sizeof w.text - (size_t)at, "%s%c",
                       k > 0 && (length - k) % 3 == 0 ? "\u202f" : "", digits[k]);
    return w;
}

brink_words brink_words_scientific(double x)
{
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴",
                                         "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[32];
    brink_words w;
    snprintf(plain, sizeof plain, "%.1e", x);
    char *exponent = strchr(plain, 'e');
    if (x == 0 || exponent == NULL) {
        snprintf(w.text, sizeof w.text, "%g", x);
        return w;
    }
    *exponent++ = '\0';
    const long power = strtol(exponent, NULL, 10), size = labs(power);
    int at = snprintf(w.text, sizeof w.text, "%s\u00a0×\u00a010%s", plain,
                      power < 0 ? "⁻" : "");
    for (long unit = size >= 100  ? 100
                     : size >= 10 ? 10
                                  : 1;
         unit > 0; unit /= 10)
        at += snprintf(w.text + at, sizeof w.text - (size_t)at, "%s",
                       raised[size / unit % 10]);
    return w;
}

// (1.4 ± 0.2) × 10⁻⁷
static brink_words rare(double frequency, double error)
{
    const int power = (int)floor(log10(frequency));
    const double unit = pow(10, power);
    brink_words w, scale = brink_words_scientific(unit);
    const char *times = strstr(scale.text, "\u00a0×");
    snprintf(w.text, sizeof w.text, "(%.2f ± %.2f)%s", frequency / unit,
             error / unit, times != NULL ? times : "");
    return w;
}

brink_words brink_words_frequency(uint64_t count, uint64_t of)
{
    brink_words w;
    const double n = (double)of, frequency = (double)count / n;
    if (of > 0 && count > 0 && frequency < 1e-3)
        return rare(frequency, sqrt((double)count) / n);
    if (of == 0)
        snprintf(w.text, sizeof w.text, "–");
    else if (count == 0)
        snprintf(w.text, sizeof w.text, "< %.40s",
                 brink_words_scientific(-log(0.05) / n).text);
    else
        snprintf(w.text, sizeof w.text, "%.4f ± %.4f", frequency,
                 sqrt((double)count) / n);
    return w;
}

brink_words brink_words_duration(double seconds)
{
    brink_words w;
    if (seconds < 120)
        snprintf(w.text, sizeof w.text, "%.1f\u00a0s", seconds);
    else if (seconds < 7200)
        snprintf(w.text, sizeof w.text, "%.1f\u00a0min", seconds / 60);
    else
        snprintf(w.text, sizeof w.text, "%.1f\u00a0h", seconds / 3600);
    return w;
}

brink_words brink_words_slug(const char *text)
{
    brink_words w;
    size_t length = 0;
    for (; *text != '\0' && length + 1 < sizeof w.text; text++)
        w.text[length++] = isalnum((unsigned char)*text) ? *text : '-';
    w.text[length] = '\0';
    return w;
}
