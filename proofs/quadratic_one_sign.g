# with: -Eprecision=160
# SPDX-License-Identifier: MIT
# quadratic.c, roots_of, where a c > 0: with d off by 1.5 ulp of D = h^2 - a c, as
# quadratic-discriminant has it, 3u at most, the two roots are off by 2.26u before their quotient
# is rounded, that is by 2.76 ulp after it: BRINK_QUADRATIC_ULP 3.  h > 0; with h < 0 all signs
# change.  Powers of two taken out, and a c > 0: 0 < D < h^2, so w <= 1/2.
@d = float<ieee_64, ne>;
h = d(h_);
a = d(a_);
c = d(c_);
dr = d(dr_);                    # d
root d= sqrt(dr);
s d= h + root;
R = sqrt(D);
S = h + R;
w = R / S;
{ h in [1b-250, 1b250] /\ D in [1b-500, 1b500] /\ dr in [1b-500, 1b500] /\ |dr -/ D| <= 3b-53
  /\ w in [0, 0.5] /\ |a| in [1b-250, 1b250] /\ |c| in [1b-250, 1b250]
 -> |s / a -/ (S / a)| <= 2509e-19 /\ |c / s -/ (c / S)| <= 2509e-19 }
(s - S)/S -> ((s - (h + root))/(h + root)) * (1 + w * ((root - R)/R)) + w * ((root - R)/R)
    { S <> 0, R <> 0, h + root <> 0 };
(root - R)/R -> ((root - sqrt(dr))/sqrt(dr)) * (1 + (sqrt(dr) - R)/R) + (sqrt(dr) - R)/R
    { R <> 0, sqrt(dr) <> 0 };
