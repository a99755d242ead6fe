// SPDX-License-Identifier: MIT
#include "reference.h"
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>

#define N MPFR_RNDN

static void dot(mpfr_t out, mpfr_t a[3], mpfr_t b[3])
{
    mpfr_mul(out, a[0], b[0], N);
    mpfr_fma(out, a[1], b[1], out, N);
    mpfr_fma(out, a[2], b[2], out, N);
}

/** r = the nearest image of x_i - x_j, u = v_i - v_j. */
static void relative(reference *w, uint32_t i, uint32_t j)
{
    for (int k = 0; k < 3; k++) {
        mpfr_sub(w->r[k], w->x[i][k], w->x[j][k], N);
        mpfr_div_d(w->t, w->r[k], w->system->length[k], N);
        mpfr_rint(w->t, w->t, N);
        mpfr_mul_d(w->t, w->t, w->system->length[k], N);
        mpfr_sub(w->r[k], w->r[k], w->t, N);
        mpfr_sub(w->u[k], w->v[i][k], w->v[j][k], N);
    }
}

/** f(t) = (r + u t)^2 - sigma^2 = a t^2 + 2 b t + c, and its discriminant d. */
static void overlap(reference *w, mpfr_t r[3], double sigma)
{
    dot(w->a, w->u, w->u);
    dot(w->b, w->u, r);
    dot(w->c, r, r);
    mpfr_set_d(w->t, sigma, N);
    mpfr_sqr(w->t, w->t, N);
    mpfr_sub(w->c, w->c, w->t, N);
    mpfr_fmms(w->d, w->b, w->b, w->a, w->c, N);
}

/** The smallest t >= 0 with f <= 0 and f' < 0.  1 and w->t, or 0: never. */
static int goes_in(reference *w, mpfr_t r[3], double sigma)
{
    dot(w->b, w->u, r);
    if (mpfr_sgn(w->b) >= 0)
        return 0;
    overlap(w, r, sigma);
    mpfr_set_zero(w->t, 1);
    if (mpfr_sgn(w->c) <= 0)
        return 1;
    if (mpfr_sgn(w->d) <= 0)
        return 0;
    mpfr_sqrt(w->d, w->d, N); // t = (-b - sqrt(d)) / a
    mpfr_add(w->t, w->b, w->d, N);
    mpfr_div(w->t, w->t, w->a, N);
    mpfr_neg(w->t, w->t, N);
    return 1;
}

/** The mirror: the smallest t >= 0 from which on f >= 0 and f' > 0; where the
 * path never enters the sphere that is the closest approach, as if d were 0. */
static int goes_out(reference *w, mpfr_t r[3], double sigma)
{
    overlap(w, r, sigma);
    if (mpfr_zero_p(w->a))
        return 0;
    if (mpfr_sgn(w->d) < 0)
        mpfr_set_zero(w->d, 1);
    mpfr_sqrt(w->d, w->d, N); // t = (-b + sqrt(d)) / a
    mpfr_sub(w->t, w->d, w->b, N);
    mpfr_div(w->t, w->t, w->a, N);
    if (mpfr_sgn(w->t) < 0)
        mpfr_set_zero(w->t, 1);
    return 1;
}

/** At one instant inward comes first; then i, then j, as pairs are looked at. */
static void keep_if_earlier(reference *w, uint32_t i, uint32_t j,
                            enum brink_direction way)
{
    int order = mpfr_cmp(w->t, w->next.dt);
    if (order < 0 || (order == 0 && way < w->next.way)) {
        mpfr_set(w->next.dt, w->t, N);
        w->next.i = i, w->next.j = j, w->next.way = way;
    }
}

/** Anything may come in, from all 27 images.  A captured pair is within half a
 *  box: it is the nearest image that goes out. */
static void look_at(reference *w, uint32_t i, uint32_t j)
{
    const brink_potential *p = brink_system_potential(w->system, i, j);
    const int level = w->level[i * w->system->count + j];
    const int depth = w->system->dimensions == 3;
    relative(w, i, j);
    if (level > 0 && goes_out(w, w->r, p->distance[level - 1]))
        keep_if_earlier(w, i, j, BRINK_OUTWARD);
    for (int z = -depth; z <= depth; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                const int shift[3] = {x, y, z};
                for (int k = 0; k < 3; k++)
                    mpfr_add_d(w->image[k], w->r[k],
                               shift[k] * w->system->length[k], N);
                if (level < p->count && goes_in(w, w->image, p->distance[level]))
                    keep_if_earlier(w, i, j, BRINK_INWARD);
            }
}

/** The time in which no pair travels further than a quarter of the box along any
 *  axis: what meets before does so in an image next to the nearest.  +inf where
 *  all are at rest. */
static double horizon(const reference *w)
{
    double h = (double)INFINITY;
    for (uint32_t i = 0; i < w->system->count; i++)
        for (int k = 0; k < 3; k++) {
            double speed = fabs(mpfr_get_d(w->v[i][k], N));
            h = fmin(h, w->system->length[k] / 8 / speed);
        }
    return h;
}

static double energy_at(const brink_potential *p, int level)
{
    return level > 0 ? p->energy[level - 1] : 0;
}

static double mass(const reference *w, uint32_t i)
{
    return w->system->species[w->system->particle[i].species].mass;
}

/** The textbook impulse along r.  With mu the reduced mass, b becomes -b where
 * the pair is reflected, way * sqrt(b^2 - 2 rise r.r / mu) where that is real. */
static enum brink_event_kind execute(reference *w)
{
    const uint32_t i = w->next.i, j = w->next.j;
    const int way = (int)w->next.way;
    const brink_potential *p = brink_system_potential(w->system, i, j);
    int *level = &w->level[i * w->system->count + j];
    double beyond = energy_at(p, *level - way);
    enum brink_event_kind kind = isinf(beyond) ? BRINK_CORE : BRINK_BOUNCE;

    relative(w, i, j);
    dot(w->a, w->r, w->r);
    dot(w->b, w->r, w->u);
    mpfr_neg(w->c, w->b, N);
    mpfr_set_d(w->t, mass(w, i), N); // 1 / mu
    mpfr_add_d(w->t, w->t, mass(w, j), N);
    mpfr_div_d(w->t, w->t, mass(w, i), N);
    mpfr_div_d(w->t, w->t, mass(w, j), N);
    mpfr_set_d(w->d, energy_at(p, *level), N); // -rise
    mpfr_sub_d(w->d, w->d, beyond, N);
    mpfr_mul(w->d, w->d, w->a, N);
    mpfr_mul(w->d, w->d, w->t, N);
    mpfr_mul_2ui(w->d, w->d, 1, N);
    mpfr_fma(w->d, w->b, w->b, w->d, N);
    if (mpfr_sgn(w->d) > 0) {
        kind = way == BRINK_INWARD ? BRINK_CAPTURE : BRINK_RELEASE;
        *level -= way;
        mpfr_sqrt(w->c, w->d, N);
        mpfr_mul_si(w->c, w->c, way, N);
    }
    mpfr_sub(w->c, w->c, w->b, N); // dp = mu (b' - b) / r.r times r
    mpfr_div(w->c, w->c, w->a, N);
    mpfr_div(w->c, w->c, w->t, N);
    for (int k = 0; k < 3; k++) {
        mpfr_mul(w->d, w->c, w->r[k], N);
        mpfr_div_d(w->t, w->d, mass(w, i), N);
        mpfr_add(w->v[i][k], w->v[i][k], w->t, N);
        mpfr_div_d(w->t, w->d, mass(w, j), N);
        mpfr_sub(w->v[j][k], w->v[j][k], w->t, N);
    }
    return kind;
}

int reference_next(reference *w, reference_event *event)
{
    const uint32_t n = w->system->count;
    w->next.i = w->next.j = 0;
    for (int looks = 0; w->next.i == w->next.j; looks++) {
        mpfr_set_d(w->next.dt, horizon(w), N);
        if (looks == REFERENCE_LOOKS || mpfr_inf_p(w->next.dt))
            return 0;
        for (uint32_t i = 0; i < n; i++)
            for (uint32_t j = i + 1; j < n; j++)
                look_at(w, i, j);
        for (uint32_t i = 0; i < n; i++)
            for (int k = 0; k < 3; k++)
                mpfr_fma(w->x[i][k], w->v[i][k], w->next.dt, w->x[i][k], N);
        mpfr_add(w->time, w->time, w->next.dt, N);
    }
    enum brink_event_kind kind = execute(w);
    *event =
        (reference_event){kind, w->next.i, w->next.j, mpfr_get_d(w->time, N)};
    return 1;
}

void reference_create(reference *w, const brink_system *system, mpfr_prec_t bits)
{
    const uint32_t n = system->count;
    *w = (reference){.system = system,
                     .x = malloc(n * sizeof *w->x),
                     .v = malloc(n * sizeof *w->v),
                     .level = calloc((size_t)n * n, sizeof *w->level)};
    mpfr_inits2(bits, w->time, w->next.dt, w->t, w->a, w->b, w->c, w->d,
                (mpfr_ptr)0);
    mpfr_set_zero(w->time, 1);
    for (int k = 0; k < 3; k++) {
        mpfr_inits2(bits, w->r[k], w->image[k], w->u[k], (mpfr_ptr)0);
        for (uint32_t i = 0; i < n; i++) {
            mpfr_inits2(bits, w->x[i][k], w->v[i][k], (mpfr_ptr)0);
            mpfr_set_uj_2exp(w->x[i][k], system->particle[i].x[k], -64, N);
            mpfr_mul_d(w->x[i][k], w->x[i][k], system->length[k], N);
            mpfr_set_d(w->v[i][k], system->particle[i].v[k], N);
        }
    }
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            const brink_potential *p = brink_system_potential(system, i, j);
            int *level = &w->level[i * n + j];
            relative(w, i, j);
            dot(w->c, w->r, w->r);
            mpfr_sqrt(w->c, w->c, N);
            while (*level < p->count && mpfr_cmp_d(w->c, p->distance[*level]) < 0)
                ++*level;
        }
}

void reference_destroy(reference *w)
{
    for (int k = 0; k < 3; k++) {
        for (uint32_t i = 0; i < w->system->count; i++)
            mpfr_clears(w->x[i][k], w->v[i][k], (mpfr_ptr)0);
        mpfr_clears(w->r[k], w->image[k], w->u[k], (mpfr_ptr)0);
    }
    mpfr_clears(w->time, w->next.dt, w->t, w->a, w->b, w->c, w->d, (mpfr_ptr)0);
    free(w->x);
    free(w->v);
    free(w->level);
}

void reference_deflect(reference *w, double size, unsigned long signs)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, signs);
    for (uint32_t i = 0; i < w->system->count; i++)
        for (int k = 0; k < w->system->dimensions; k++) {
            const double x = gsl_rng_uniform(rng) < 0.5 ? -size : size;
            const double v = gsl_rng_uniform(rng) < 0.5 ? -size : size;
            mpfr_add_d(w->x[i][k], w->x[i][k], x * w->system->length[k], N);
            mpfr_mul_d(w->t, w->v[i][k], v, N);
            mpfr_add(w->v[i][k], w->v[i][k], w->t, N);
        }
    gsl_rng_free(rng);
}
