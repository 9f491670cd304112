# What a build of the physics can leave out. The sources of a feature that is off give way to world/without/NAME.cpp, which
# defines the functions that others call: stages that do nothing, and refusals. No other file knows, and none has an #ifdef
# (docs/adr/014-features.md).
#
# cairn_feature(NAME "what it is" SOURCES...): the option CAIRN_WITH_NAME, on unless told otherwise.
function(cairn_feature name what)
  option(CAIRN_WITH_${name} "Physics: ${what}" ON)
  set(cairn_features ${cairn_features} ${name} PARENT_SCOPE)
  if(CAIRN_WITH_${name})
    target_sources(cairn_physics PRIVATE ${ARGN})
  else()
    string(TOLOWER ${name} file)
    target_sources(cairn_physics PRIVATE world/without/${file}.cpp)
  endif()
  set_property(SOURCE world/features.cpp APPEND PROPERTY COMPILE_DEFINITIONS
               CAIRN_WITH_${name}=$<BOOL:${CAIRN_WITH_${name}}>)
endfunction()

cairn_feature(JOINTS "joints of all kinds"
  resolve/joints/distance.cpp
  resolve/joints/exact_spring.cpp
  resolve/joints/spring_mobility.cpp
  resolve/joints/frame.cpp
  resolve/joints/friction.cpp
  resolve/joints/gear.cpp
  resolve/joints/joint_kernels.cpp
  resolve/joints/joint_lanes.cpp
  resolve/joints/joint_place_kernel.cpp
  resolve/joints/joint_pool.cpp
  resolve/joints/joint_solver.cpp
  resolve/joints/laws.cpp
  resolve/joints/motor.cpp
  resolve/joints/mouse.cpp
  resolve/joints/place.cpp
  resolve/joints/prismatic.cpp
  resolve/joints/pin_load_kernel.cpp
  resolve/joints/pin_loads.cpp
  resolve/joints/pulley.cpp
  resolve/joints/revolute.cpp
  resolve/joints/torn_joints.cpp
  resolve/joints/weld.cpp
  resolve/joints/wheel.cpp
  resolve/joints/wheel_kernels.cpp
  world/joint_constraints.cpp
  world/joint_lists.cpp
  world/joint_measures.cpp
  world/joint_rules.cpp
  world/joints.cpp
  world/stiff_springs.cpp)
cairn_feature(DIRECT_SOLVER "the direct solver of joint structures and uneven contacts (needs joints)"
  resolve/direct/block_ldl.cpp
  resolve/direct/chain_factors.cpp
  resolve/direct/direct_component.cpp
  resolve/direct/direct_descent.cpp
  resolve/direct/direct_energy.cpp
  resolve/direct/direct_equations.cpp
  resolve/direct/direct_structure.cpp
  resolve/direct/direct_system.cpp
  resolve/direct/ldl_numbers.cpp
  resolve/direct/pin_chain.cpp
  resolve/direct/pin_chain_energy.cpp
  resolve/direct/pin_chain_row.cpp
  resolve/direct/pin_row.cpp
  resolve/joints/pin_statics.cpp
  world/direct_groups.cpp
  world/direct_solve.cpp
  world/direct_structures.cpp
  world/pin_loads.cpp)
cairn_feature(SENSORS "shapes that note what overlaps them"
  world/sensors.cpp)
cairn_feature(CHAINS "runs of one-sided segments"
  collide/chains.cpp
  world/chain_rules.cpp
  world/chains.cpp)
cairn_feature(EVENTS "begin, end and hit of contacts"
  world/contact_events.cpp)
cairn_feature(FRACTURE "cuts, breaks and breakable bodies"
  collide/fracture_sites.cpp
  collide/ring.cpp
  collide/voronoi.cpp
  world/break_plan.cpp
  world/breakables.cpp
  world/cut_plan.cpp
  world/fracture.cpp
  world/fragments.cpp
  world/world_fracture.cpp)
cairn_feature(RESTITUTION "impacts that give back speed"
  resolve/impacts.cpp
  resolve/restitution.cpp
  resolve/restitution_kernel.cpp
  world/bounce_energy.cpp
  world/bounces.cpp
  world/faint_bounces.cpp
  world/impact_groups.cpp)
cairn_feature(ROLLING_RESISTANCE "torques that resist rolling"
  resolve/rolling.cpp)
cairn_feature(SURFACE_SPEED "surfaces that run, as of conveyor belts"
  world/surface_speed.cpp)
cairn_feature(EFFECTS "explosions and wind"
  world/explosion.cpp
  world/wind.cpp
  world/world_effects.cpp)
cairn_feature(MOVER "characters that walk"
  world/mover.cpp)
cairn_feature(SNAPSHOTS "snapshots, going back to them, recordings"
  state/body_state.cpp
  state/broad_state.cpp
  state/checksum.cpp
  state/contact_blocks.cpp
  state/contact_list_state.cpp
  state/contact_state.cpp
  state/delta.cpp
  state/event_state.cpp
  state/frame.cpp
  state/joint_state.cpp
  state/link_state.cpp
  state/recording.cpp
  state/shape_state.cpp
  state/snapshot.cpp)
cairn_feature(PREFABS "things made of several bodies and joints"
  prefabs/blob.cpp
  prefabs/brick_wall.cpp
  prefabs/bridge.cpp
  prefabs/elevator.cpp
  prefabs/gear_train.cpp
  prefabs/hanging_line.cpp
  prefabs/link_chain.cpp
  prefabs/linked_bodies.cpp
  prefabs/pendulum.cpp
  prefabs/pulley_lift.cpp
  prefabs/ragdoll.cpp
  prefabs/rope.cpp
  prefabs/vehicle.cpp
  prefabs/windmill.cpp)

if(CAIRN_WITH_DIRECT_SOLVER AND NOT CAIRN_WITH_JOINTS)
  message(FATAL_ERROR "CAIRN_WITH_DIRECT_SOLVER=ON needs CAIRN_WITH_JOINTS=ON: it solves what joints describe.")
endif()
if(CAIRN_TESTS AND PROJECT_IS_TOP_LEVEL)
  foreach(feature IN LISTS cairn_features)
    if(NOT CAIRN_WITH_${feature})
      message(FATAL_ERROR "CAIRN_WITH_${feature}=OFF needs CAIRN_TESTS=OFF: the tests use all features.")
    endif()
  endforeach()
endif()
