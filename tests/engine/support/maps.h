// A folder for maps of Tiled, with a tile set in it.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <utility>

#include <cairn/engine/files.h>
#include <cairn/engine/tile_map.h>

#include "engine/support/temporary_folder.h"

struct Maps {
    Maps() {
        auto made = cairn::engine::Files::create({});
        REQUIRE(made);
        files = std::move(*made);
        REQUIRE(files->mount(folder.path().string()));
        folder.put(
            "maps/sets/ground.tsx",
            R"(<?xml version="1.0"?><tileset name="ground" tilewidth="16" tileheight="16" tilecount="8" columns="4"
                   margin="1" spacing="2"><image source="../../art/ground.png" width="80" height="40"/>
                   <tile id="2" class="grass"><properties><property name="solid" type="bool" value="true"/></properties></tile>
                   <tile id="5"><animation><frame tileid="5" duration="100"/><frame tileid="6" duration="300"/></animation></tile>
                   </tileset>)");
    }
    cairn::engine::Result<cairn::engine::TileMap> load(const std::string& name, const std::string& text) {
        folder.put("maps/" + name, text);
        return cairn::engine::load_tile_map(*files, "maps/" + name);
    }
    /// Of what must be without a fault.
    cairn::engine::TileMap good(const std::string& name, const std::string& text) {
        cairn::engine::Result<cairn::engine::TileMap> map = load(name, text);
        if (!map) FAIL(map.error().message);
        return *std::move(map);
    }
    TemporaryFolder folder;
    std::unique_ptr<cairn::engine::Files> files;
};

/// A map of 3 x 2 cells of 16 pixels whose layer's data element is given.
inline std::string tmx(const std::string& data, const std::string& more = "") {
    return R"(<?xml version="1.0" encoding="UTF-8"?><map version="1.10" orientation="orthogonal" width="3" height="2"
        tilewidth="16" tileheight="16" infinite="0" backgroundcolor="#ff8000"><properties>
        <property name="title" value="7"/><property name="wind" type="float" value="0.5"/></properties>
        <tileset firstgid="1" source="sets/ground.tsx"/><layer id="1" name="ground" width="3" height="2" opacity="0.5">)" +
           data + "</layer>" + more + "</map>";
}

inline constexpr const char* kCsv = "<data encoding=\"csv\">\n1,0,3,\n2147483650,1610612741,8\n</data>";
