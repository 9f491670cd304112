// The described fields of prefabs: what `cairn.prefab.rope(world, {...})` and the others take.
#pragma once

#include <lua.hpp>

#include <cairn/physics/prefabs/all.h>

#include "bind/fields.h"

namespace cairn::scripting {

/// What a table describes, and the fields that it may have.
template <class Def>
struct PrefabReader;

#define CAIRN_PREFAB_READER(Def)                                           \
    template <>                                                            \
    struct PrefabReader<physics::Def> {                                    \
        static const FieldSet kFields;                                     \
        static physics::Def read(lua_State* L, const FieldReader& reader); \
    }
CAIRN_PREFAB_READER(LinkChainDef);
CAIRN_PREFAB_READER(RopeDef);
CAIRN_PREFAB_READER(BridgeDef);
CAIRN_PREFAB_READER(VehicleDef);
CAIRN_PREFAB_READER(RagdollDef);
CAIRN_PREFAB_READER(BrickWallDef);
CAIRN_PREFAB_READER(BlobDef);
CAIRN_PREFAB_READER(PendulumDef);
CAIRN_PREFAB_READER(WindmillDef);
CAIRN_PREFAB_READER(ElevatorDef);
CAIRN_PREFAB_READER(GearTrainDef);
CAIRN_PREFAB_READER(PulleyLiftDef);
#undef CAIRN_PREFAB_READER

/// The table that becomes `data` of every body, or a new one for each: pushed.
void push_prefab_data(lua_State* L, const FieldReader& reader);

}  // namespace cairn::scripting
