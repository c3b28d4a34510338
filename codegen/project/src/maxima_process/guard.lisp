;;; What Maxima loads before a worksheet: messages of the driver, and functions that refuse what reaches beyond it.

(in-package :maxima)

(defvar *closedform-mark* @MARK@)
(defvar *closedform-guarded* @GUARDED@)

;; Whether Maxima reads a file that comes with it, where Lisp may stand.
(defvar *closedform-shipped-text* nil)

;; Where files may be loaded from: what comes with Maxima, and our own two files.
(defvar *closedform-own* (list @DRIVER@ @BATCH@))
;; Worksheets beside the one that is run: they may be loaded, and are run as it is.
(defvar *closedform-beside* '(@BESIDE@))
(when *closedform-beside*
  (setq $file_search_maxima (list* '(mlist) "###.mac" (cdr $file_search_maxima))))

(defun closedform-place (file)
  (let ((found (and (or (stringp file) (symbolp file))
                    ($file_search1 file '((mlist) $file_search_maxima $file_search_lisp)))))
    (and (stringp found) (namestring (truename found)))))

(defun closedform-stands-beside (file)
  (and *closedform-beside*
       (member (closedform-place file) *closedform-beside* :test #'equal)))

(defvar *closedform-shipped* (remove nil (list *maxima-sharedir* *maxima-srcdir*)))

;; The driver's own functions; installed once more when it is loaded, whatever the worksheet called so.
(defun closedform-install-messages ()
  (dolist (function-name '($closedform_say $closedform_version))
    (mremprop function-name 'mexpr)
    (mremprop function-name 'mmacro)
    (remprop function-name 'mfexpr*)
    (remprop function-name 'translated-mmacro))
  (setf (symbol-function '$closedform_say)
        #'(lambda (text) (terpri) (princ *closedform-mark*) (princ ($sconcat text)) (terpri) '$done))
  (setf (symbol-function '$closedform_version) #'(lambda () *autoconf-version*)))

(defun closedform-refuse (function-name)
  (merror "~M reaches beyond the worksheet: it is run with --allow-system only" function-name))

(defun closedform-replace (function-name)
  (mremprop function-name 'mexpr)
  (remprop function-name 'mfexpr*)
  (remprop function-name 'autoload)
  (remprop function-name 'translated-mmacro)
  (setf (symbol-function function-name)
        #'(lambda (&rest arguments) (declare (ignore arguments)) (closedform-refuse function-name))))

(defun closedform-begins (prefix text)
  (and (>= (length text) (length prefix)) (string= prefix text :end2 (length prefix))))

(defun closedform-replace-all ()
  (dolist (function-name '(@REFUSED@))
    (closedform-replace (intern (concatenate 'string "$" (string-upcase function-name)) :maxima)))
  (let ((drawing (mapcar #'(lambda (function-name) (concatenate 'string "$" (string-upcase function-name))) '(@DRAWING@))) (found nil))
    (do-symbols (symbol :maxima)
      (when (and (or (fboundp symbol) (get symbol 'mfexpr*))
                 (some #'(lambda (prefix) (closedform-begins prefix (symbol-name symbol))) drawing))
        (push symbol found)))
    (mapc #'closedform-replace found)))

;; `tex` prints, and writes only where it is told a file.
(defun closedform-watch-tex ()
  (let ((original (get '$tex 'mfexpr*)))
    (when original
      (setf (get '$tex 'mfexpr*)
            #'(lambda (form) (if (cddr form) (closedform-refuse '$tex) (funcall original form)))))))

(defun closedform-may-load (file)
  (let ((found (and (or (stringp file) (symbolp file))
                    (or (and (stringp file) (member file *closedform-own* :test #'string=) file)
                        ($file_search1 file '((mlist) $file_search_maxima $file_search_lisp))))))
    (and (stringp found)
         (or (member found *closedform-own* :test #'string=)
             (closedform-stands-beside file)
             (let ((place (namestring (truename found))))
               (some #'(lambda (folder)
                       (let ((folder (ignore-errors (namestring (truename (concatenate 'string folder "/"))))))
                         (and folder (closedform-begins folder place))))
                     *closedform-shipped*))))))

;; A function that runs a file runs only those; what a package brings is guarded again.
(defun closedform-watch (function-name)
  (let ((original (symbol-function function-name)))
    (setf (symbol-function function-name)
          #'(lambda (file &rest more)
            (unless (closedform-may-load file) (closedform-refuse function-name))
            (when (equal file (first *closedform-own*)) (closedform-install-messages))
            (prog1 (let ((*closedform-shipped-text*
                           (not (or (equal file (second *closedform-own*))
                                    (and (not (member file *closedform-own* :test #'equal))
                                         (closedform-stands-beside file))))))
                     (apply original file more))
              (closedform-replace-all))))))

;; From here on a question is an error of the statement that asks it.
(setf (symbol-function '$closedform_ask_nothing)
      #'(lambda ()
          (setf (symbol-function 'retrieve)
                #'(lambda (message &rest more)
                    (declare (ignore more))
                    (merror "Maxima asks: ~A" (if (consp message) (apply #'$sconcat (cdr message)) message))))
          '$done))

(closedform-install-messages)

(if *closedform-guarded*
    (progn
      (mapc #'closedform-watch '($load $batch $batchload))
      (let ((original (symbol-function 'scan-lisp-token)))
        (setf (symbol-function 'scan-lisp-token)
              #'(lambda (&rest arguments)
                  (if *closedform-shipped-text*
                      (apply original arguments)
                      (merror "Lisp is run with --allow-system only")))))
      (dolist (command '(:lisp :lisp-quiet)) (remprop command 'break-command))
      (closedform-watch-tex)
      (closedform-replace-all))
    (let ((original (symbol-function '$load)))
      (setf (symbol-function '$load)
            #'(lambda (file &rest more)
              (when (equal file (first *closedform-own*)) (closedform-install-messages))
              (apply original file more)))))
