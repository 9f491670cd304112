// Checks for bugs: CAIRN_ASSERT is cheap and always on, CAIRN_VALIDATE is expensive and on in debug builds.
#pragma once

namespace cairn::physics {

[[noreturn]] void fail_assertion(const char* condition, const char* what, const char* file, int line);

}  // namespace cairn::physics

#define CAIRN_ASSERT(condition, what) \
    ((condition) ? void() : ::cairn::physics::fail_assertion(#condition, what, __FILE__, __LINE__))

#ifdef NDEBUG
#define CAIRN_VALIDATE(condition, what) void()
#else
#define CAIRN_VALIDATE(condition, what) CAIRN_ASSERT(condition, what)
#endif
