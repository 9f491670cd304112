// Everything that the physics offers in C++ can be had in Lua. The oracle is the public headers themselves:
// each method of their classes must have a binding of the same name, or stand here with the one that does its
// work.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "bind/module.h"
#include "support/source_path.h"

namespace cairn::scripting::test {
namespace {

/// What of C++ is called otherwise in Lua; "" is what Lua has no need of: handles, views and overloads.
const std::map<std::string, std::string> kElsewhere = {
    {"World:World", "cairn.physics.new_world"},
    {"World:create", "cairn.physics.new_world"},
    {"World:create_body", "World:new_body"},
    {"World:create_bodies", "World:add_bodies"},
    {"World:destroy_body", "Body:destroy"},
    {"World:body", ""},
    {"World:living_body", ""},
    {"World:position_of", "Body:position"},
    {"World:contains", "Body:is_valid"},
    {"World:create_shape", "Body:add_polygon"},
    {"World:destroy_shape", "Shape:destroy"},
    {"World:shape", ""},
    {"World:create_chain", "Body:add_chain"},
    {"World:destroy_chain", "Chain:destroy"},
    {"World:chain", ""},
    {"World:create_joint", "World:add_revolute_joint"},
    {"World:destroy_joint", "Joint:destroy"},
    {"World:joint", ""},
    {"World:contact_begins", "World:events"},
    {"World:contact_ends", "World:events"},
    {"World:contact_hits", "World:events"},
    {"World:sensor_begins", "World:sensor_events"},
    {"World:sensor_ends", "World:sensor_events"},
    {"World:sensor_overlaps", "Shape:overlaps"},
    {"World:shape_at", "World:body_at"},
    {"World:cut_body", "Body:cut"},
    {"World:break_body", "Body:fracture"},
    {"World:set_breakable", "Body:set_breakable"},
    {"World:clear_breakable", "Body:clear_breakable"},
    {"World:breakable", "Body:breakable"},
    {"World:body_breaks", "World:breaks"},
    {"World:counts", "World:report"},
    {"World:awake_body_count", "World:awake_count"},
    {"World:max_penetration_m", "World:report"},
    {"World:profile", "World:report"},
    {"World:own", ""},
    {"World:debug_contacts", "World:contacts"},
    {"World:debug_islands", "World:islands"},
    {"World:debug_boxes", "World:boxes"},
    {"Shape:id", ""},
    {"Shape:outline", "Shape:points"},
    {"Shape:one_way_normal", "Shape:one_way"},
    {"Shape:set_one_way_normal", "Shape:set_one_way"},
    {"Shape:user_data", ""},  // shape.data
    {"Shape:set_user_data", ""},
    {"Body:id", ""},
    {"Body:mass_data", "Body:local_center"},
    {"Body:user_data", ""},  // body.data
    {"Body:set_user_data", ""},
    {"Chain:id", ""},
    {"Chain:points", "Chain:point"},
    {"Chain:segment_count", "Chain:point_count"},
    {"Chain:user_data", ""},  // chain.data
    {"Chain:set_user_data", ""},
    {"Joint:id", ""},
    {"Joint:user_data", ""},  // joint.data
    {"Joint:set_user_data", ""},
    {"Joint:joint_angle", "Joint:angle"},
    {"Joint:current_length", "Joint:length"},
    {"Joint:definition", "Joint:parameters"},
    {"Joint:redefine", "Joint:change"},
    {"Mover:create", "cairn.physics.new_mover"},
    {"Mover:def", ""},  // what new_mover was given
    {"Recording:Recording", "cairn.physics.new_recording"},
};

std::set<std::string> bindings() {
    std::set<std::string> names;
    for (const Module* module : all_modules()) {
        for (const Function& function : module->functions)
            names.insert(std::string(module->name) + (module->is_type ? ":" : ".") + function.name);
    }
    return names;
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The names that are declared as functions of a class, outside of bodies and comments.
std::set<std::string> public_methods(const std::string& header, const std::string& class_name) {
    std::ifstream file(cairn::test::source_path("physics/include/cairn/physics/" + header));
    std::set<std::string> methods;
    bool is_inside = false;
    for (std::string line; std::getline(file, line);) {
        if (line == "class " + class_name + " {") is_inside = true;
        if (!is_inside) continue;
        if (line == "  private:") break;
        line = line.substr(0, line.find("//"));
        // A declaration stands at the first indent; what continues one stands deeper.
        if (line.size() < 5 || line.substr(0, 4) != "    " || line[4] == ' ' || line[4] == '~') continue;
        const std::size_t open = line.find('(');
        if (open == std::string::npos || line.find("operator") != std::string::npos) continue;
        std::size_t begin = open;
        while (begin > 0 && is_word(line[begin - 1])) --begin;
        if (begin < open) methods.insert(line.substr(begin, open - begin));
    }
    return methods;
}

}  // namespace

TEST_CASE("every method of the physics' public classes can be had in Lua") {
    const std::set<std::string> known = bindings();
    const std::pair<const char*, const char*> classes[] = {
        {"world.h", "World"}, {"world.h", "Shape"}, {"body.h", "Body"},          {"chain.h", "Chain"},
        {"joint.h", "Joint"}, {"mover.h", "Mover"}, {"recording.h", "Recording"}};
    std::set<std::string> seen;
    for (const auto& [header, name] : classes) {
        const std::set<std::string> methods = public_methods(header, name);
        CHECK(methods.size() >= 7);
        for (const std::string& method : methods) {
            const std::string full = std::string(name) + ':' + method;
            seen.insert(full);
            const auto elsewhere = kElsewhere.find(full);
            INFO(full);
            CHECK((known.contains(full) || elsewhere != kElsewhere.end()));
        }
    }
    CHECK(seen.size() > 150);
    for (const auto& [method, binding] : kElsewhere) {
        INFO(method << " -> " << binding);
        CHECK(seen.contains(method));  // none that is gone
        CHECK((binding.empty() || known.contains(binding)));
    }
}

}  // namespace cairn::scripting::test
