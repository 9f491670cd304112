// Stands for rolling resistance in a build without it: validate(Material) refuses it.
#include "resolve/contact_points.h"

namespace cairn::physics {

void solve_rolling(ContactConstraint&, Motion&, Motion&) {}

}  // namespace cairn::physics
