// SPDX-License-Identifier: MIT
// What goes through lanes is what goes through doubles.
#include "../tests/oracle_dd.h"
#include "../tests/pairs.h"
#include "fuzz.h"
#include <brink/event_time_lanes.h>

static _Noreturn void broken(const char *what, const double *x, int n)
{
    FINDING("lanes: %s", what);
    finding_numbers("x", n, x);
    finding_end();
}

/** Any six; where a second rounding of x y + z would show, in half of them. */
static void check_fma(stream *s)
{
    double x[6];
    for (int k = 0; k < 6; k++)
        x[k] = stream_scaled(s, -400, 400);
    for (int k = 0; k < 2; k++)
        if (stream_int(s, 0, 1))
            x[4 + k] = stream_near(s, -x[k] * x[2 + k], 2);
    const two_lanes z =
        lanes_fma((two_lanes){x[0], x[1]}, (two_lanes){x[2], x[3]},
                  (two_lanes){x[4], x[5]});
    for (int k = 0; k < 2; k++)
        if (z[k] != fma(x[k], x[2 + k], x[4 + k]))
            broken("fma", x, 6);
}

/** A number at some 2^-78 to 2^-68 of itself from a midpoint, told or not: if it
 *  is, it is so wherever within 2^-75 of itself the truth lies. */
static dd some_doubt(stream *s)
{
    const double x = stream_int(s, 0, 7) ? stream_real(s, 1, 2) : 1;
    const double side = stream_sign(s), next = nextafter(x, side * 4);
    const double off = stream_scaled(s, -79, -67);
    return (dd){x, (next - x) / 2 + off * x};
}

static void check_told(stream *s)
{
    const dd x[2] = {some_doubt(s), some_doubt(s)};
    const double all[4] = {x[0].hi, x[0].lo, x[1].hi, x[1].lo};
    two_lanes nearest;
    if (!lanes_are_told((two_lanes){x[0].hi, x[1].hi},
                        (two_lanes){x[0].lo, x[1].lo}, &nearest))
        return;
    mpfr_t z, moved;
    mpfr_inits2(ORACLE_BITS, z, moved, (mpfr_ptr)0);
    for (int k = 0; k < 2; k++) {
        oracle_set_dd(z, x[k]);
        for (int way = -1; way <= 1; way++) {
            mpfr_add_d(moved, z, way * 0x1p-75 * x[k].hi, ORACLE_N);
            if (mpfr_get_d(moved, ORACLE_N) != nearest[k])
                broken("told, but not certain", all, 4);
        }
    }
    mpfr_clears(z, moved, (mpfr_ptr)0);
}

static void check_sums(stream *s)
{
    double x[8];
    for (int k = 0; k < 8; k++)
        x[k] = stream_scaled(s, -60, 60);
    const two_lanes a = {x[0], x[1]}, b = {x[2], x[3]};
    const two_lanes lost = lanes_lost(a + b, a, b);
    for (int k = 0; k < 2; k++)
        if (lost[k] != two_sum(x[k], x[2 + k]).lo)
            broken("what a sum loses", x, 4);

    const four_lanes c = {x[0], x[1], x[2], x[3]}, d = {x[4], x[5], x[6], x[7]};
    four_lanes product = c * d, low, sum = c, left = {0, 0, 0, 0};
    four_lost_by_product(&low, &c, &d, &product);
    four_add(&sum, &left, &d);
    for (int k = 0; k < 4; k++) {
        const dd p = two_prod(x[k], x[4 + k]), t = two_sum(x[k], x[4 + k]);
        if (product[k] != p.hi || low[k] != p.lo)
            broken("what a product loses", x, 8);
        if (sum[k] != t.hi || left[k] != t.lo)
            broken("what four sums lose", x, 8);
    }
}

/** sums_in_lanes and dots_in_lanes are sums_of and dot_of to the bit. */
static void check_pair(stream *s)
{
    pair_case p;
    pair_families[stream_int(s, 0, PAIR_FAMILIES - 1)].make(s, &p);
    const sums x = sums_of(p.r, p.v, p.sigma),
               y = sums_in_lanes(p.r, p.v, p.sigma);
    const two_dots dots = dots_in_lanes(p.r, p.v);
    const dd rv = dot_of(p.r, p.v), rr = dot_of(p.r, p.r);
    const double one[12] = {x.a.hi,    x.a.lo, x.b.hi, x.b.lo, x.c.hi, x.c.lo,
                            x.c_error, x.size, rv.hi,  rv.lo,  rr.hi,  rr.lo};
    const double other[12] = {y.a.hi,     y.a.lo,     y.b.hi,     y.b.lo,
                              y.c.hi,     y.c.lo,     y.c_error,  y.size,
                              dots.rv.hi, dots.rv.lo, dots.rr.hi, dots.rr.lo};
    for (int k = 0; k < 12; k++)
        if (one[k] != other[k] && !(isnan(one[k]) && isnan(other[k])))
            broken("a pair's sums", &p.r[0], 7);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    check_fma(&s);
    check_told(&s);
    check_sums(&s);
    check_pair(&s);
    return 0;
}
