// The words of an error about a number: "circle.radius_m is -1, but must be greater than 0". Each check gives
// nothing when the rule holds. The first failing one of a list is what the user sees.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include <cairn/physics/math.h>
#include <cairn/physics/result.h>

namespace cairn::physics::check {

using Fault = std::optional<Error>;

std::string number(double value);  ///< shortest text that reads back as the same float

Fault finite(const char* field, double value);
Fault finite(const char* field, Vec2 value);
Fault finite(const char* field, Position value);
/// Finite, and within kFarthest_m of the world's origin along each axis.
Fault placed(const char* field, Position value);
Fault positive(const char* field, double value);      ///< finite and > 0
Fault not_negative(const char* field, double value);  ///< finite and >= 0
Fault within(const char* field, double value, double low, double high);
/// An error with the rule in words.
Fault require(bool holds, const char* field, double value, const char* rule);

Fault first_of(std::initializer_list<Fault> faults);

}  // namespace cairn::physics::check
