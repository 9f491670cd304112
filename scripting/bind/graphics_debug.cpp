// The debug drawing for games that want it in a place, or under a camera, of their own.
#include "bind/graphics_debug.h"

#include "bind/graphics_objects.h"
#include "debug/debug_draw.h"

namespace cairn::scripting {
namespace {

constexpr DebugDrawOptions kDefaults{};
constexpr Field kShapes =
    boolean_field("shapes", kDefaults.shapes, "true outlines, with a mark of how they are turned");
constexpr Field kContacts =
    boolean_field("contacts", kDefaults.contacts, "points, and impulses along normal and surface");
constexpr Field kJoints = boolean_field("joints", kDefaults.joints, "by kind, with anchors and limits");
constexpr Field kIslands =
    boolean_field("islands", kDefaults.islands, "one color for bodies that fall asleep together");
constexpr Field kBoxes = boolean_field("boxes", kDefaults.boxes, "of the broad phase");
constexpr Field kCenters = boolean_field("centers", kDefaults.centers, "of mass");
constexpr const Field* kOwn[] = {&kShapes, &kContacts, &kJoints, &kIslands, &kBoxes, &kCenters};

}  // namespace

constinit const FieldSet kDebugDrawFields{kOwn};

void draw_debug_world(lua_State* L, WorldRef world, std::optional<TableArgument> options) {
    Context& context = drawing_context(L);
    if (!options) lua_newtable(L);
    const FieldReader reader(L, options ? options->index : -1, kDebugDrawFields);
    draw_debug(context.services.renderer, world.world,
               {.shapes = reader.boolean(kShapes),
                .contacts = reader.boolean(kContacts),
                .joints = reader.boolean(kJoints),
                .islands = reader.boolean(kIslands),
                .boxes = reader.boolean(kBoxes),
                .centers = reader.boolean(kCenters),
                .alpha = static_cast<float>(context.alpha)});
}

}  // namespace cairn::scripting
