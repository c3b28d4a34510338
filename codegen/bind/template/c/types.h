
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a call says: one of the constants below. */
typedef int @PREFIX@_status;

enum {
    /** Every result is as good as its bound. */
    @CONSTANT@_OK = 0,
    /** The inputs lie outside the domain of the kernel; the text names the condition. */
    @CONSTANT@_OUTSIDE_DOMAIN = 1,
    /** A double cannot hold a result: it overflows, loses digits by underflow, or is not decided; the text says which. */
    @CONSTANT@_OUT_OF_RANGE = 2,
    /** Arrays are not of one length, or longer than memory. */
    @CONSTANT@_LENGTH = 3,
    /** A pointer is null. */
    @CONSTANT@_NULL = 4,
    /** A pointer is not aligned as its type demands. */
    @CONSTANT@_MISALIGNED = 5,
    /** An array of results shares memory with another array. */
    @CONSTANT@_OVERLAP = 6
};

/** Numbers to be read. The pointer may be null where the length is 0. */
typedef struct @PREFIX@_view {
    const double *data;
    size_t length;
} @PREFIX@_view;

/** Numbers to be written. The pointer may be null where the length is 0. */
typedef struct @PREFIX@_span {
    double *data;
    size_t length;
} @PREFIX@_span;

/** An input of a kernel. Texts are in UTF-8 and never null. */
typedef struct @PREFIX@_input {
    const char *name;
    /** Its name in the worksheet. */
    const char *worksheet;
    /** Its unit; "1" or empty for a number. */
    const char *unit;
    /** The magnitudes to expect. */
    double typical_least;
    double typical_most;
} @PREFIX@_input;

/** A result of a kernel. */
typedef struct @PREFIX@_result {
    const char *name;
    /** The function of the worksheet that defines it. */
    const char *worksheet;
    const char *unit;
    /** The error in ulp that it never exceeds; NaN where none is proved. */
    double bound_ulp;
} @PREFIX@_result;

/** What is known of a kernel. */
typedef struct @PREFIX@_info {
    const char *name;
    const char *summary;
    /** The closed form as Maxima text, a definition a line. */
    const char *maxima;
    const char *latex;
    /** Where the formula is derived. */
    const char *source;
    /** What the default call computes in. */
    const char *precision;
    const @PREFIX@_input *inputs;
    size_t input_count;
    /** The conditions that inputs must meet besides being finite. */
    const char *const *domain;
    size_t domain_count;
    const @PREFIX@_result *results;
    size_t result_count;
    /** The k of: inputs that are 0 or of a magnitude from 2^-k to 2^k take the quick way; 0 where there is none. */
    unsigned ordinary;
} @PREFIX@_info;

/** How many kernels there are. */
size_t @PREFIX@_count(void);

/** The kernel at a position; null beyond the last one. */
const @PREFIX@_info *@PREFIX@_at(size_t position);
