// SPDX-License-Identifier: MIT
#include "bench_words.h"
#include <stdio.h>

brink_words bench_error(double ulps)
{
    brink_words w;
    if (isinf(ulps))
        snprintf(w.text, sizeof w.text, "∞");
    else if (ulps >= 1e4)
        return brink_words_scientific(ulps);
    else
        snprintf(w.text, sizeof w.text, "%.*f",
                 ulps == 0 || ulps >= 10 ? 0
                 : ulps >= 0.1           ? 2
                                         : 4,
                 ulps);
    return w;
}

brink_words bench_percent(double part)
{
    brink_words w;
    snprintf(w.text, sizeof w.text, "%.2g %%", 100 * part);
    return w;
}

brink_words bench_wrong(const standing *s)
{
    brink_words w;
    const int wrong = measure_wrong(&s->all);
    if (wrong >= 100)
        return bench_percent(standing_wrong(s));
    if (wrong == 0)
        snprintf(w.text, sizeof w.text, "none");
    else
        snprintf(w.text, sizeof w.text, "%d of %.40s", wrong,
                 brink_words_grouped((uint64_t)s->all.n).text);
    return w;
}

brink_words bench_ratio(double ratio)
{
    brink_words w;
    if (ratio >= 100)
        return brink_words_grouped((uint64_t)(ratio + 0.5));
    snprintf(w.text, sizeof w.text, "%.*f",
             ratio < 3    ? 2
             : ratio < 10 ? 1
                          : 0,
             ratio);
    return w;
}

/** The first of this rank; NULL if there is none. */
static const standing *of_rank(const contest *c, enum rank rank)
{
    for (int k = 0; k < c->problem->methods; k++)
        if (c->of[k].method->rank == rank)
            return &c->of[k];
    return NULL;
}

static void tell_ours(FILE *out, const contest *c)
{
    const standing *plain = of_rank(c, RANK_PLAIN), *cr = of_rank(c, RANK_CR),
                   *fast = of_rank(c, RANK_FAST);
    fprintf(out, "Of %s answers of %s ",
            brink_words_grouped((uint64_t)plain->all.n).text,
            plain->method->about);
    if (measure_wrong(&plain->all) == 0)
        fprintf(out, "none was wrong, and the worst was off by %s %s",
                bench_error(standing_max(plain, 0)).text, c->problem->measure[0]);
    else
        fprintf(out, "%s were wrong", bench_wrong(plain).text);
    fprintf(out, "; a call costs %s times what “%s” costs.",
            bench_ratio(plain->ratio).text, c->of[0].method->label);
    if (cr != NULL && measure_wrong(&cr->all) == 0 && standing_max(cr, 0) <= 0.5)
        fprintf(out,
                " For %s times, every answer is the double nearest to the truth.",
                bench_ratio(cr->ratio).text);
    if (fast != NULL)
        fprintf(out,
                " The fast tier, %s times, may judge a grazing pair otherwise; "
                "at its worst the pair was %s eps of its path from the surface.",
                bench_ratio(fast->ratio).text,
                bench_error(standing_max(fast, 1)).text);
}

/** Those that were wrong, and those that were not; not the judge, nor ours. */
static void tell_rivals(FILE *out, const contest *c)
{
    int right = 0, rivals = 0;
    const standing *best = NULL;
    for (int k = 0; k < c->problem->methods; k++) {
        const standing *s = &c->of[k];
        if (s->method->rank <= RANK_SIGN || s->method->rank == RANK_JUDGE)
            continue;
        rivals++;
        if (measure_wrong(&s->all) > 0)
            continue;
        right++;
        if (best == NULL || s->ns < best->ns)
            best = s;
    }
    fprintf(out, " “%s” was wrong in %s of them.", c->of[0].method->label,
            bench_wrong(&c->of[0]).text);
    if (right == 0)
        fprintf(out, " None of the %d rivals was always right.", rivals);
    else if (right < rivals)
        fprintf(out,
                " Of %d rivals %d %s never wrong; the cheapest, %s, costs %s and "
                "was off by up to %s %s.",
                rivals, right, right == 1 ? "was" : "were", best->method->label,
                bench_ratio(best->ratio).text,
                bench_error(standing_max(best, 0)).text, c->problem->measure[0]);
}

char *bench_sentences(const contest *c)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return NULL;
    tell_ours(out, c);
    tell_rivals(out, c);
    return fclose(out) == 0 ? text : NULL;
}

char *bench_headline(const contest *c)
{
    char *text = NULL;
    size_t size = 0;
    const standing *plain = of_rank(c, RANK_PLAIN);
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return NULL;
    fprintf(out,
            "%s. Of %s answers brink was wrong in %s, “%s” in %s; brink costs %s "
            "times "
            "as much.",
            c->problem->title, brink_words_grouped((uint64_t)plain->all.n).text,
            bench_wrong(plain).text, c->of[0].method->label,
            bench_wrong(&c->of[0]).text, bench_ratio(plain->ratio).text);
    return fclose(out) == 0 ? text : NULL;
}
