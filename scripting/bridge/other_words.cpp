// A small list: what is misspelt or has a part of a name in common is found without it.
#include "bridge/other_words.h"

namespace cairn::scripting {
namespace {

constexpr OtherWord kOtherWords[] = {
    {"hinge hinge_joint pin pin_joint hingejoint revolute", "world:add_revolute_joint", ""},
    {"slider_joint groove groove_joint prismatic", "world:add_prismatic_joint", ""},
    {"fixed_joint weld glue", "world:add_weld_joint", ""},
    {"rope rope_joint max_distance", "max_length world:add_distance_joint cairn.prefab.rope",
     "a distance joint with a max_length and frequency = 0 is a rope"},
    {"max_length", "world:add_distance_joint cairn.prefab.rope", ""},
    {"spring spring_joint damped_spring", "world:add_distance_joint enable_spring", ""},
    {"mouse_spring target_joint grab", "world:add_mouse_joint", ""},
    {"rigidbody rigid_body rigidbody2d rigid_body2d rigid_body_2d new_rigid_body create_body",
     "world:add_box world:add_circle world:new_body", ""},
    {"fixture new_fixture create_fixture collider collision_shape", "shape body:add_box",
     "there are no fixtures: a body has shapes"},
    {"rectangle_shape box_shape", "world:add_box", ""},
    {"edge_shape edge terrain", "world:add_chain", ""},
    {"trigger is_trigger area area2d area_2d set_sensor", "sensor world:sensor_events", ""},
    {"collision collisions collide begin_contact end_contact pre_solve post_solve on_collision "
     "on_collision_enter on_collision_enter2d body_entered set_callbacks",
     "world:events world:contacts", ""},
    {"on_trigger_enter on_trigger_enter2d area_entered", "world:sensor_events", ""},
    {"layer collision_layer category category_bits", "categories", ""},
    {"collision_mask mask_bits layer_mask", "mask", ""},
    {"group_index", "group", ""},
    {"bounce bounciness elasticity", "restitution", ""},
    {"linear_drag drag_linear", "linear_damping", ""},
    {"angular_drag", "angular_damping", ""},
    {"fixed_rotation freeze_rotation lock_rotations constraints", "lock_rotation body:set_locks", ""},
    {"bullet ccd continuous continuous_cd collision_detection tunnelling tunneling", "world:step",
     "there is nothing to set: whatever is fast is swept, so that it passes through nothing"},
    {"static kinematic dynamic body_type is_kinematic", "type", ""},
    {"set_velocity", "body:linear_velocity body:set_linear_velocity", ""},
    {"add_force force", "body:apply_force body:apply_force_to_center", ""},
    {"add_impulse apply_linear_impulse apply_central_impulse",
     "body:apply_impulse body:apply_impulse_to_center", ""},
    {"add_torque torque", "body:apply_torque", ""},
    {"raycast ray_cast ray_cast2d raycast2d intersect_ray", "world:cast_ray world:cast_ray_all", ""},
    {"shape_cast box_cast circle_cast", "world:cast_shape world:cast_shape_all", ""},
    {"query_aabb query_bounding_box overlap overlap_box overlap_circle overlap_point",
     "world:shapes_overlapping world:shapes_in_box world:body_at", ""},
    {"conveyor tangent_speed constant_linear_velocity", "surface_speed", ""},
    {"one_way_collision platform_effector", "one_way_y shape:set_one_way", ""},
    {"character_controller character_body kinematic_body move_and_slide move_and_collide",
     "cairn.physics.new_mover mover:move", ""},
    {"user_data get_user_data set_user_data", "",
     "body.data, shape.data and joint.data are tables of your own"},
    {"meter set_meter pixels_per_meter ppm", "camera",
     "the world is in metres; a camera makes pixels of them"},
    {"fixed_update physics_process process delta delta_time dt", "cairn.update", ""},
    {"ready init setup", "cairn.load", ""},
    {"keypressed keyreleased key_down get_key get_key_down is_key_pressed is_scancode_down",
     "key_pressed key_released cairn.input.is_down", ""},
    {"mousepressed mousereleased mousemoved mouse_down get_mouse_button",
     "mouse_pressed mouse_released mouse_moved cairn.input.is_mouse_down", ""},
    {"wheelmoved wheel_moved", "cairn.wheel", ""},
    {"joystick get_axis is_gamepad_button_down", "cairn.input.is_gamepad_down cairn.input.gamepad_axis", ""},
    {"input_map get_action_strength", "cairn.input.bind cairn.input.action_value", ""},
    {"sprite texture", "cairn.graphics.new_image cairn.graphics.draw", ""},
    {"sprite_batch new_sprite_batch", "cairn.graphics.new_batch", ""},
    {"sprite_sheet spritesheet texture_atlas", "cairn.graphics.new_atlas", ""},
    {"render_texture framebuffer", "cairn.graphics.new_canvas", ""},
    {"printf draw_text", "cairn.graphics.print cairn.text.new", ""},
    {"nine_slice 9_slice nine_patch_rect", "cairn.graphics.draw_nine_patch", ""},
    {"debug_draw draw_gizmos gizmos", "cairn.graphics.draw_debug", ""},
    {"viewport camera2d", "camera", ""},
    {"particle_system new_particle_system gpu_particles", "particles", ""},
    {"tiled tile_map sti", "tilemap", ""},
    {"gui widget menu control", "ui", ""},
    {"sound source new_source play_one_shot audio_source", "cairn.audio.play cairn.audio.play_music", ""},
    {"invoke set_timeout wait_for_seconds create_timer", "cairn.timer.after", ""},
    {"set_interval invoke_repeating", "cairn.timer.every", ""},
    {"lerp animate interpolate flux", "cairn.tween.to", ""},
    {"filesystem player_prefs file_access", "files", ""},
    {"instantiate", "prefab level", ""},
    {"game_state gamestate change_scene load_scene", "scene", ""},
};

}  // namespace

std::span<const OtherWord> other_words() {
    return kOtherWords;
}

const OtherWord* other_word(std::string_view word) {
    for (const OtherWord& entry : kOtherWords) {
        std::string_view rest = entry.words;
        while (!rest.empty()) {
            const std::size_t end = rest.find(' ');
            if (rest.substr(0, end) == word) return &entry;
            rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
        }
    }
    return nullptr;
}

}  // namespace cairn::scripting
