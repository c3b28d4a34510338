;; Trees of Maxima's parser without what differs by spelling only, and their comparison.
(in-package :maxima)

(defun fold-left (head first rest)
  (dolist (next rest first) (setq first (list head first (plain next)))))

(defparameter *operators*
  '(mtimes mquotient mexpt mnctimes mncexpt mequal mnotequal mlessp mleqp mgreaterp mgeqp mand mor mnot msetq mset mdefine
    mdefmacro mminus mfactorial mlist mprogn mcond mquote mdo mdoin))

(defun plain-symbol (name)
  (cond ((null name) (list "NIL"))
        ((eq name 'lambda) (list "SYMBOL" "$LAMBDA"))
        ((eq name 'mprog) (list "SYMBOL" "$BLOCK"))
        (t (list "SYMBOL" (symbol-name name)))))

(defun plain-list (head array parts)
  (cond ((eq head 'bigfloat) (cons "BIGFLOAT" parts))
        ((eq head 'mqapply) (cons (if array "SUBSCRIPT" "CALL") (mapcar #'plain parts)))
        ((and (eq head 'mplus) (null (cdr parts))) (list "PLUS" (plain (car parts))))
        ((eq head 'mplus) (fold-left "ADD" (plain (car parts)) (cdr parts)))
        ((member head '(mtimes mand mor)) (fold-left (symbol-name head) (plain (car parts)) (cdr parts)))
        ((member head *operators*) (cons (symbol-name head) (mapcar #'plain parts)))
        (t (list* (if array "SUBSCRIPT" "CALL") (plain-symbol head) (mapcar #'plain parts)))))

(defun plain (tree)
  (cond ((numberp tree) tree)
        ((stringp tree) (list "STRING" tree))
        ((symbolp tree) (plain-symbol tree))
        (t (plain-list (caar tree) (member 'array (cdar tree)) (cdr tree)))))

;; Bigfloats are handed over as text.
(defun resolved (tree)
  (cond ((atom tree) tree)
        ((equal (car tree) "BIGFLOAT-TEXT") (plain ($parse_string (cadr tree))))
        (t (mapcar #'resolved tree))))

;; The product without the minus before its first factor; nil if there is none. Maxima reads a-b*c as a sum of -(b*c), but
;; a+b-c*d as one of (-c)*d.
(defun without-minus (tree)
  (cond ((atom tree) nil)
        ((equal (car tree) "MMINUS") (cadr tree))
        ((member (car tree) '("MTIMES" "MQUOTIENT" "MNCTIMES") :test #'equal)
         (let ((first (without-minus (cadr tree)))) (and first (list* (car tree) first (cddr tree)))))))

(defun with-differences (tree)
  (if (atom tree) tree
      (let* ((parts (mapcar #'with-differences tree)) (rest (and (equal (car parts) "ADD") (without-minus (caddr parts)))))
        (if rest (list "SUB" (cadr parts) rest) parts))))

(defun reading (text)
  (let ((*standard-output* (make-broadcast-stream)))
    (catch 'macsyma-quit (list 'read ($parse_string text)))))

(defun read-well (answer) (and (consp answer) (eq (car answer) 'read)))

(defun compare-reading (index text expected)
  (let ((answer (reading text)) (*print-pretty* nil))
    (cond ((not (read-well answer)) (format t "~&case ~a refused~%" index))
          ((equal (with-differences (plain (cadr answer))) (with-differences (resolved expected))) (format t "~&case ~a same~%" index))
          (t (format t "~&case ~a ~s, not ~s~%" index (plain (cadr answer)) expected)))))

(defun refuse-reading (index text)
  (format t "~&case ~a ~a~%" index (if (read-well (reading text)) "accepted" "refused")))
