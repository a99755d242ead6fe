# with: -Eprecision=160
# SPDX-License-Identifier: MIT
# event_time_meeting.h, time_of_meeting: within BRINK_EVENT_TIME_ULP 8 of C / (sqrt(D) - B), B < 0
# < C, D, for what its guards leave: the sum that c was rounded from is off by 2.851u of itself
# (is_known), d by 2.4u (discriminant_of), the sum that b was rounded from by 7u^2 P, which is less
# than 2^-78 of the denominator as P^2 <= Q < 2^44 d.  As D < B^2, w <= 1/2.  8u of the time are at
# most 8 ulp.
@d = float<ieee_64, ne>;
c = d(cs);
b = d(bs);
dr = d(dr_);                    # d
root d= sqrt(dr);
s d= root - b;
t d= c / s;
R = sqrt(D);
S = R - B;
w = R / S;
e = (root - b - S) / S;
{ C in [1b-450, 1b450] /\ cs in [1b-450, 1b450] /\ |cs -/ C| <= 3166e-19
  /\ D in [1b-450, 1b450] /\ dr in [1b-450, 1b450] /\ |dr -/ D| <= 2665e-19
  /\ -B in [1b-225, 1b225] /\ -bs in [1b-230, 1b225] /\ |(bs - B) / S| <= 1b-78 /\ w in [0, 0.5]
 -> |t -/ (C / S)| <= 8b-53 }
(s - S)/S -> ((s - (root - b))/(root - b)) * (1 + e) + e { S <> 0, root - b <> 0 };
e -> w * ((root - R)/R) - ((b - bs)/bs) * ((bs - B)/S - (1 - w)) - (bs - B)/S
    { S <> 0, R <> 0, bs <> 0 };
(root - R)/R -> ((root - sqrt(dr))/sqrt(dr)) * (1 + (sqrt(dr) - R)/R) + (sqrt(dr) - R)/R
    { R <> 0, sqrt(dr) <> 0 };
