// The main function of every test program. Catch wraps its reports; this width keeps commands whole.
#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_CONSOLE_WIDTH 160
#include <catch2/catch.hpp>
