# What every Cairn target has in common: the language level, warnings, sanitizers, and the floating-point rules that
# make one source give one result on every compiler.

# cairn_compile_options(TARGET): applies them, privately.
function(cairn_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  # Contracting a * b + c to one rounding changes bits between compilers and processors, so it is off everywhere.
  # Definitions leave fields out on purpose, each has a default. g++ 12 sees overlaps inside std::string that cannot be.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
                                           -Wno-missing-field-initializers $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
  # Told of a processor that can, g++ 12 contracts all the same where it adds and subtracts in turn. AVX-512 would bring
  # FMA back.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "86|AMD64|amd64")
    target_compile_options(${target} PRIVATE -mno-fma -mno-fma4 -mno-avx512f)
  endif()
  if(CAIRN_SANITIZE)
    # Public: a program that links a sanitized library must link the sanitizer's run-time library too.
    target_compile_options(${target} PUBLIC -fsanitize=${CAIRN_SANITIZE} -fno-omit-frame-pointer)
    target_compile_options(${target} PRIVATE -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${CAIRN_SANITIZE})
  endif()
endfunction()

# cairn_precompile(TARGET HEADERS...): what most files of the target include is parsed once for all of them. Only by clang, which
# takes half the time then: g++ takes longer to load such a header than to parse what a small file needs of it. A file that
# forgets an include does not compile with g++.
function(cairn_precompile target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# cairn_simd(TARGET): Highway, with every level that a processor may offer except those that gain nothing over the next:
# eight lanes are enough.
function(cairn_simd target)
  find_package(hwy REQUIRED)
  target_link_libraries(${target} PRIVATE hwy::hwy)
  target_compile_definitions(${target} PRIVATE HWY_COMPILE_ALL_ATTAINABLE
                                               "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX3|HWY_AVX3_DL)")
  if(CAIRN_SANITIZE)
    # With these two checks world/box_cover_kernel.cpp takes clang 52 s instead of 6, and an index that leaves its object is
    # found by its address. With addresses checked by calls where a function has many, not in their midst,
    # resolve/contact_kernels.cpp takes it 15 s instead of 42.
    target_compile_options(${target} PRIVATE -fno-sanitize=pointer-overflow,object-size
                           "$<$<CXX_COMPILER_ID:Clang>:SHELL:-mllvm -asan-instrumentation-with-call-threshold=500>")
  endif()
endfunction()

# cairn_library(NAME HEADERS... SOURCES...): the library cairn_NAME, known as cairn::NAME, with its public headers
# under include/ as a file set and its own folder as the private include root.
function(cairn_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;SOURCES")
  add_library(cairn_${name} ${arg_SOURCES})
  add_library(cairn::${name} ALIAS cairn_${name})
  set_target_properties(cairn_${name} PROPERTIES EXPORT_NAME ${name})
  target_sources(cairn_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${arg_HEADERS})
  target_include_directories(cairn_${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  cairn_compile_options(cairn_${name})
endfunction()
