// All prefabs.
#pragma once

#include <cairn/physics/prefabs/blob.h>
#include <cairn/physics/prefabs/brick_wall.h>
#include <cairn/physics/prefabs/bridge.h>
#include <cairn/physics/prefabs/elevator.h>
#include <cairn/physics/prefabs/gear_train.h>
#include <cairn/physics/prefabs/link_chain.h>
#include <cairn/physics/prefabs/pendulum.h>
#include <cairn/physics/prefabs/pulley_lift.h>
#include <cairn/physics/prefabs/ragdoll.h>
#include <cairn/physics/prefabs/rope.h>
#include <cairn/physics/prefabs/vehicle.h>
#include <cairn/physics/prefabs/windmill.h>
