// What happens when a bug is found: a message on standard error, and the end of the program.
#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

#include <cairn/physics/result.h>

namespace cairn::physics {

void fail_assertion(const char* condition, const char* what, const char* file, int line) {
    std::fprintf(stderr, "cairn: %s (%s is false, %s:%d)\n", what, condition, file, line);
    std::abort();
}

void detail::fail_unchecked_result(const Error& error) {
    std::fprintf(stderr, "cairn: a failed result was used: %s\n", error.message.c_str());
    std::abort();
}

}  // namespace cairn::physics
