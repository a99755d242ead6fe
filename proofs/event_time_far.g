# with: -Eprecision=160
# SPDX-License-Identifier: MIT
# event_time_parting.h, far pairs: later_root's (sqrt(d) - b) / a, d off by 2.4u, a by 3u and b
# as in event_time_meeting.g, is within 7.2u; and passing_time's -b / a within 6.2u, where b was
# rounded once from a sum off by 1.1u (is_passing_known): BRINK_EVENT_TIME_ULP 8.  B and b stand
# for -B > 0 and -b.
@d = float<ieee_64, ne>;
a = d(a_);
b = d(bs);                      # |b|
dr = d(dr_);                    # d
root d= sqrt(dr);
s d= root + b;
t d= s / a;
R = sqrt(D);
S = R + B;
w = R / S;
e = (root + b - S) / S;
p = d(ps);                      # |b|, of dot_closely
passing d= p / a;
{ A in [1b-450, 1b450] /\ a in [1b-450, 1b450] /\ |a -/ A| <= 3331e-19
  /\ D in [1b-450, 1b450] /\ dr in [1b-450, 1b450] /\ |dr -/ D| <= 2665e-19
  /\ B in [1b-225, 1b225] /\ bs in [1b-230, 1b225] /\ |(bs - B) / S| <= 1b-78 /\ w in [0, 0.5]
  /\ ps in [1b-230, 1b225] /\ |ps -/ B| <= 1222e-19
 -> |t -/ (S / A)| <= 7994e-19 /\ |passing -/ (B / A)| <= 6884e-19 }
(s - S)/S -> ((s - (root + b))/(root + b)) * (1 + e) + e { S <> 0, root + b <> 0 };
e -> w * ((root - R)/R) + ((b - bs)/bs) * ((bs - B)/S + (1 - w)) + (bs - B)/S
    { S <> 0, R <> 0, bs <> 0 };
(root - R)/R -> ((root - sqrt(dr))/sqrt(dr)) * (1 + (sqrt(dr) - R)/R) + (sqrt(dr) - R)/R
    { R <> 0, sqrt(dr) <> 0 };
