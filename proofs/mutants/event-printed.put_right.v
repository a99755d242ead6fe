(* refutes: printed_is_not_a_number *)
(* SPDX-License-Identifier: MIT *)
(* Put right it is a number. *)
From Brink Require Import event_time_printed.

Theorem is_false : ltac:(let T := type of printed_is_not_a_number in exact (T -> False)).
Proof. vm_compute; discriminate. Qed.
