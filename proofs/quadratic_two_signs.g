# with: -Eprecision=160
# SPDX-License-Identifier: MIT
# quadratic.c, discriminant_of and roots_of, where a c < 0, q = -a c: s is off by 2.501u of
# S = h + sqrt(D), D = h^2 + q, and so is each root before its quotient is rounded: 3.001 ulp
# after it, BRINK_QUADRATIC_ULP 3 but for 2^-9.  h > 0; with h < 0 all signs change.  qh is -q.hi and q - qh is -q.lo, exact; z, what is rounded first, is 0,
# and then f is exact, or a multiple of 2^-620 as h and q are.
# products: q
@d = float<ieee_64, ne>;
h = d(h_);
q = D - h * h;
qh = d(q);
z = h * h + (q - qh);
f = d(z);
dr d= f + qh;
root d= sqrt(dr);
s d= h + root;
R = sqrt(D);
S = h + R;
k = h / R;
{ h in [1b-250, 1b250] /\ D in [1b-500, 1b500] /\ q in [1b-500, 1b500] /\ |z| in [1b-620, 1b500]
  /\ f + qh in [1b-500, 1b500] /\ dr in [1b-500, 1b500] /\ k in [0, 1] /\ q / D in [0, 1]
 -> |(s - S) / S| <= 2776e-19 }
(s - S)/S -> ((s - (h + root))/(h + root)) * (1 + ((root - R)/R) * (1 / (1 + k)))
    + ((root - R)/R) * (1 / (1 + k)) { S <> 0, R <> 0, h + root <> 0, 1 + k <> 0 };
(root - R)/R -> ((root - sqrt(dr))/sqrt(dr)) * (1 + (sqrt(dr) - R)/R) + (sqrt(dr) - R)/R
    { R <> 0, sqrt(dr) <> 0 };
(dr - D)/D -> ((dr - (f + qh))/(f + qh)) * (1 + (f + qh - D)/D) + (f + qh - D)/D
    { D <> 0, f + qh <> 0 };
(f + qh - D)/D -> ((f - z)/z) * (k * k - ((qh - q)/q) * (q / D))
    { R <> 0, D <> 0, q <> 0, z <> 0 };
$ k in 64;
