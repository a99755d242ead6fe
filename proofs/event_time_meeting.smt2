; SPDX-License-Identifier: MIT
; time_of_meeting is a number and not negative, whatever doubles its verdict leaves it: c > 0,
; b < 0, c and b finite, d any number.  In binary64, bit by bit.
(set-logic QF_FP)
(define-sort Double () (_ FloatingPoint 11 53))
(define-fun zero () Double (_ +zero 11 53))
(declare-const b Double)
(declare-const c Double)
(declare-const d Double)
(assert (and (fp.lt b zero) (not (fp.isInfinite b))))
(assert (and (fp.gt c zero) (not (fp.isInfinite c))))
(assert (not (fp.isNaN d)))
(define-fun root () Double (fp.sqrt RNE (fp.abs d)))
(define-fun t () Double (fp.div RNE c (fp.sub RNE root b)))
(assert (not (fp.geq t zero)))
(check-sat)
