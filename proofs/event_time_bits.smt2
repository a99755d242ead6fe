; with: --incremental
; SPDX-License-Identifier: MIT
; What is asked of a double's bits is what is meant, for every double, NaN and infinities among
; them.  x, y, z are any 64 bits.
(set-logic QF_BVFP)
(define-sort Double () (_ FloatingPoint 11 53))
(define-sort Bits () (_ BitVec 64))
(declare-const x Bits)
(declare-const y Bits)
(declare-const z Bits)
(define-fun number ((b Bits)) Double ((_ to_fp 11 53) b))
(define-fun zero () Double (_ +zero 11 53))
(define-fun power ((biased (_ BitVec 11))) Double (fp #b0 biased (_ bv0 52)))
(define-fun within ((b Bits) (least Double) (most Double)) Bool
  (and (fp.leq least (number b)) (fp.lt (number b) most)))

; is_radius: finite, and not negative; not -0.0 either, for which the slow ways are good enough.
(define-fun is_radius ((b Bits)) Bool (bvult (bvlshr b (_ bv52 64)) (_ bv2047 64)))
(push)
(assert (not (= (is_radius x)
  (and (not (fp.isNaN (number x))) (not (fp.isInfinite (number x)))
       (= ((_ extract 63 63) x) #b0)))))
(check-sat)
(pop)

; are_in_range: both in [2^-256, 2^256).
(define-fun above ((b Bits) (least Bits)) Bits (bvsub (bvlshr b (_ bv52 64)) least))
(define-fun are_in_range () Bool
  (bvult (bvor (above x (_ bv767 64)) (above y (_ bv767 64))) (_ bv512 64)))
(push)
(assert (not (= are_in_range
  (and (within x (power (_ bv767 11)) (power (_ bv1279 11)))
       (within y (power (_ bv767 11)) (power (_ bv1279 11)))))))
(check-sat)
(pop)

; are_moderate: all in [2^-512, 2^512).
(define-fun are_moderate () Bool
  (bvult (bvor (bvor (above x (_ bv511 64)) (above y (_ bv511 64))) (above z (_ bv511 64)))
         (_ bv1024 64)))
(push)
(assert (not (= are_moderate
  (and (within x (power (_ bv511 11)) (power (_ bv1535 11)))
       (within y (power (_ bv511 11)) (power (_ bv1535 11)))
       (within z (power (_ bv511 11)) (power (_ bv1535 11)))))))
(check-sat)
(pop)

; twice_below(b) is 0 or -2 b, exactly: doubling is a step of the exponent (or of a subnormal's
; bits); where 2 b is infinite so is it, and of no number it makes none.
(define-fun b () Double (number x))
(define-fun twice_below () Double (fp.sub RNE (fp.abs b) b))
(push)
(assert (not (fp.isInfinite b)))
(assert (not (ite (fp.isNaN b) (fp.isNaN twice_below)
  (ite (fp.isNegative b) (fp.eq twice_below (fp.mul RNE (fp.neg b) (power (_ bv1024 11))))
                         (= twice_below zero)))))
(check-sat)
(pop)

; sign_of: -(b >> 63) | 1 is -1 of what is negative and 1 of what is positive.
(define-fun sign_of () Bits (bvor (bvneg (bvlshr x (_ bv63 64))) (_ bv1 64)))
(push)
(assert (not (and (=> (fp.lt b zero) (= sign_of (bvneg (_ bv1 64))))
                  (=> (fp.gt b zero) (= sign_of (_ bv1 64))))))
(check-sat)
(pop)

; choose: one of two, without a branch; first is 0 or 1.
(declare-const first Bits)
(define-fun mask () Bits (bvneg first))
(define-fun choose () Bits (bvor (bvand x mask) (bvand y (bvnot mask))))
(push)
(assert (bvule first (_ bv1 64)))
(assert (not (= choose (ite (= first (_ bv1 64)) x y))))
(check-sat)
(pop)
