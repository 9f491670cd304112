// Work in a process of its own: what ends that process, from an assertion to a loop without end, ends nothing
// else.
#pragma once

#include <functional>
#include <string>

namespace cairn::lab {

struct Answer {
    std::string text;      ///< what the work returned
    std::string ended_by;  ///< what ended it before its time; empty when nothing did
};

/// No thread of this process but the calling one may be running.
Answer ask_child(const std::function<std::string()>& work);

}  // namespace cairn::lab
