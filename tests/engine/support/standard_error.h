// What a piece of code writes to standard error past everything, as libraries of C do.
#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

template <class Function>
std::string written_to_standard_error(Function&& function) {
    std::fflush(stderr);
    std::FILE* file = std::tmpfile();
    const int kept = dup(STDERR_FILENO);
    dup2(fileno(file), STDERR_FILENO);
    function();
    std::fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    std::string text;
    std::rewind(file);
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
    std::fclose(file);
    return text;
}
