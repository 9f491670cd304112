// Maps of Tiled in XML and JSON, and every way to write tiles, layers and objects.
#include <catch2/catch.hpp>

#include "engine/support/maps.h"

using namespace cairn::engine;

namespace {

std::vector<std::uint32_t> ids(const MapLayer& layer) {
    std::vector<std::uint32_t> all;
    for (const Tile& tile : layer.tiles) all.push_back(tile.id);
    return all;
}

}  // namespace

TEST_CASE_METHOD(Maps, "a map has its size, its sets, its layers and its properties") {
    const TileMap map = good("a.tmx", tmx(kCsv));
    CHECK(map.columns == 3);
    CHECK(map.rows == 2);
    CHECK(map.tile_size == Size{16, 16});
    CHECK(map.background == Color{1, 128 / 255.0f, 0, 1});
    CHECK(std::get<std::string>(map.properties.at("title")) == "7");
    CHECK(std::get<double>(map.properties.at("wind")) == 0.5);
    REQUIRE(map.sets.size() == 1);
    CHECK(map.sets[0].image_path == "art/ground.png");
    CHECK(map.sets[0].source(1) == Rect{1, 1, 16, 16});
    CHECK(map.sets[0].source(6) == Rect{19, 19, 16, 16});
    const MapLayer* ground = map.layer("ground");
    REQUIRE(ground);
    CHECK(ground->color == Color{1, 1, 1, 0.5f});
    CHECK(ids(*ground) == std::vector<std::uint32_t>{1, 0, 3, 2, 5, 8});
    CHECK(ground->tiles[3] == Tile{.id = 2, .flip_x = true});
    CHECK(ground->tiles[4] == Tile{.id = 5, .flip_y = true, .flip_diagonal = true});
}

TEST_CASE_METHOD(Maps, "tiles have properties, and animated ones show frame after frame") {
    const TileMap map = good("a.tmx", tmx(kCsv));
    CHECK(std::get<bool>(map.properties_of(3).at("solid")));
    CHECK(std::get<std::string>(map.properties_of(3).at("class")) == "grass");
    CHECK(map.properties_of(1).empty());
    CHECK(map.properties_of(0).empty());
    CHECK(map.shown(6, 0.05) == 6);
    CHECK(map.shown(6, 0.15) == 7);
    CHECK(map.shown(6, 0.39) == 7);
    CHECK(map.shown(6, 0.45) == 6);
    CHECK(map.shown(3, 9) == 3);
}

TEST_CASE_METHOD(Maps, "every way to write the tiles gives the same tiles") {
    // The same six numbers, written by Python's base64, zlib and gzip.
    const std::vector<std::uint32_t> expected = {1, 0, 3, 2, 5, 8};
    for (const char* data :
         {"<data encoding=\"base64\">AQAAAAAAAAADAAAAAgAAAAUAAAAIAAAA</data>",
          "<data encoding=\"base64\" compression=\"zlib\">eJxjZIAAZiBmAmJWIOYAYgAAwAAU</data>",
          "<data encoding=\"base64\" "
          "compression=\"gzip\">H4sIAAAAAAACA2NkgABmIGYCYlYg5gBiAOGjQ2oYAAAA</data>",
          "<data encoding=\"csv\">1,0,3,2,5,8</data>",
          "<data><tile gid=\"1\"/><tile/><tile gid=\"3\"/>\n<tile gid=\"2\"/><tile gid=\"5\"/><tile "
          "gid=\"8\"/></data>"}) {
        INFO(data);
        const TileMap map = good("b.tmx", tmx(data));
        CHECK(ids(map.layers[0]) == expected);
    }
}

TEST_CASE_METHOD(Maps, "elements for tiles keep their flags, and are counted and checked") {
    const TileMap map =
        good("e.tmx", tmx("<data><tile gid=\"2147483650\"/><tile/><tile/><tile/><tile/><tile/></data>"));
    CHECK(map.layers[0].tiles[0] == Tile{.id = 2, .flip_x = true});
    CHECK_THAT(load("e.tmx", tmx("<data><tile gid=\"1\"/></data>")).error().message,
               Catch::Contains("data has 1 tiles, but there are 6 cells"));
    CHECK_THAT(load("e.tmx", tmx("<data><tile gid=\"-1\"/></data>")).error().message,
               Catch::Contains("must hold tile numbers"));
}

TEST_CASE_METHOD(Maps, "image layers have their picture and what is done to it, in XML and in JSON") {
    const TileMap xml = good(
        "i.tmx", tmx(kCsv, R"(<group name="far" offsetx="5" offsety="-2" opacity="0.5" tintcolor="#ff8000"
        parallaxx="0.5" visible="0"><imagelayer name="sky" offsetx="1" opacity="0.5" tintcolor="#80ffffff" parallaxx="0.5"
        parallaxy="0.25" repeatx="1"><image source="../art/sky.png" width="64" height="32"/></imagelayer></group>
        <imagelayer name="near" repeatx="0" repeaty="1"><image source="near.png"/></imagelayer>)"));
    const TileMap json = good(
        "i.tmj", R"({"orientation": "orthogonal", "width": 3, "height": 2, "tilewidth": 16, "tileheight": 16,
        "tilesets": [], "layers": [{"type": "group", "name": "far", "offsetx": 5, "offsety": -2, "opacity": 0.5,
        "tintcolor": "#ff8000", "parallaxx": 0.5, "visible": false, "layers": [{"type": "imagelayer", "name": "sky", "offsetx": 1,
        "opacity": 0.5, "tintcolor": "#80ffffff", "parallaxx": 0.5, "parallaxy": 0.25, "repeatx": true,
        "image": "../art/sky.png"}]}, {"type": "imagelayer", "name": "near", "repeaty": true, "image": "near.png"}]})");
    for (const TileMap& map : {xml, json}) {
        const MapLayer* sky = map.layer("far/sky");
        REQUIRE(sky);
        CHECK(sky->kind == MapLayer::Kind::Image);
        CHECK(sky->image_path == "art/sky.png");
        CHECK_FALSE(sky->is_visible);
        CHECK(sky->offset == Vec2{6, -2});
        CHECK(sky->color == Color{1, 128 / 255.0f, 0, 0.25f * (128 / 255.0f)});
        CHECK(sky->parallax == Vec2{0.25f, 0.25f});
        CHECK(sky->image_corner == Vec2{});
        CHECK(sky->repeats_x);
        CHECK_FALSE(sky->repeats_y);
        const MapLayer* near = map.layer("near");
        REQUIRE(near);
        CHECK(near->image_path == "maps/near.png");
        CHECK(near->color == Color{});
        CHECK(near->parallax == Vec2{1, 1});
        CHECK_FALSE(near->repeats_x);
        CHECK(near->repeats_y);
    }
}

TEST_CASE_METHOD(Maps, "the transparent color of a picture is that of its tile set or layer") {
    const TileMap xml =
        good("t.tmx", R"(<map width="1" height="1" tilewidth="8" tileheight="8"><tileset firstgid="1" name="a"
        tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="a.png" trans="ff8000"/></tileset>
        <tileset firstgid="2" name="b" tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="b.png"/></tileset>
        <imagelayer name="c"><image source="c.png" trans="#000000"/></imagelayer></map>)");
    const std::string set =
        R"("tilewidth": 8, "tileheight": 8, "tilecount": 1, "columns": 1, "image": "a.png")";
    const TileMap json =
        good("t.tmj", R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8, "tilesets": [
        {"firstgid": 1, "transparentcolor": "#ff8000", )" +
                          set + R"(}, {"firstgid": 2, )" + set + R"(}],
        "layers": [{"type": "imagelayer", "name": "c", "image": "c.png", "transparentcolor": "#000000"}]})");
    for (const TileMap& map : {xml, json}) {
        REQUIRE(map.sets.size() == 2);
        CHECK(map.sets[0].transparent == Color{1, 128 / 255.0f, 0, 1});
        CHECK_FALSE(map.sets[1].transparent);
        CHECK(map.layers[0].transparent == Color{0, 0, 0, 1});
    }
    folder.put("maps/w.tmj",
               R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8, "layers": [], "tilesets": [
        {"firstgid": 1, "transparentcolor": 7, )" +
                   set + "}]}");
    CHECK(read_tile_map(*files, "maps/w.tmj").faults ==
          std::vector<std::string>{"maps/w.tmj:2: tilesets[1].transparentcolor is 7, but must be a text"});
}

// "The parallax scrolling factor is applied based on the distance of the center of the view from the parallax
// origin": at 1 a layer moves with the map, at 0 with the view, at 0.5 half as much.
TEST_CASE_METHOD(Maps, "parallax moves layers by their factors with the middle of the view") {
    const TileMap map =
        good("p.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8, "parallaxoriginx": 10,
        "parallaxoriginy": -4, "layers": [
        {"type": "imagelayer", "name": "near", "image": "a.png"},
        {"type": "imagelayer", "name": "far", "image": "a.png", "parallaxx": 0.5, "parallaxy": 2},
        {"type": "imagelayer", "name": "fixed", "image": "a.png", "parallaxx": 0, "parallaxy": 0}]})");
    for (const MapLayer& layer : map.layers) CHECK(map.parallax_shift(layer, {10, -4}) == Vec2{0, 0});
    CHECK(map.parallax_shift(map.layers[0], {50, 16}) == Vec2{0, 0});
    CHECK(map.parallax_shift(map.layers[1], {50, 16}) == Vec2{20, -20});
    CHECK(map.parallax_shift(map.layers[2], {50, 16}) == Vec2{40, 20});
}

TEST_CASE_METHOD(Maps, "JSON says the same as XML") {
    const std::string set =
        R"({"firstgid": 1, "name": "ground", "tilewidth": 16, "tileheight": 16, "tilecount": 8,
        "columns": 4, "margin": 1, "spacing": 2, "image": "../art/ground.png",
        "tiles": [{"id": 2, "type": "grass", "properties": [{"name": "solid", "type": "bool", "value": true}]}]})";
    const TileMap json =
        good("a.tmj", R"({"orientation": "orthogonal", "infinite": false, "width": 3, "height": 2,
        "tilewidth": 16, "tileheight": 16, "backgroundcolor": "#ff8000", "tilesets": [)" +
                          set +
                          R"(], "layers": [{"type": "tilelayer", "name": "ground", "opacity": 0.5,
        "data": [1, 0, 3, 2147483650, 1610612741, 8]}]})");
    const TileMap xml = good("a.tmx", tmx(kCsv));
    CHECK(json.layers[0].tiles == xml.layers[0].tiles);
    CHECK(json.layers[0].color == xml.layers[0].color);
    CHECK(json.sets[0].image_path == xml.sets[0].image_path);
    CHECK(json.properties_of(3) == xml.properties_of(3));
    CHECK(json.background == xml.background);
}

TEST_CASE_METHOD(Maps, "an infinite map is as large as what was drawn in it, and objects move along") {
    const auto infinite = [](const std::string& grid, const std::string& layers) {
        return "<map version=\"1.10\" " + grid +
               " width=\"30\" height=\"20\" tilewidth=\"16\" tileheight=\"8\" infinite=\"1\">"
               "<tileset firstgid=\"1\" source=\"sets/ground.tsx\"/>" +
               layers + "</map>";
    };
    const std::string layers = R"(<layer id="1" name="ground" width="30" height="20"><data encoding="csv">
        <chunk x="-2" y="-3" width="2" height="2">1,2,3,4</chunk>
        <chunk x="1" y="-2" width="1" height="3">5,6,7</chunk></data></layer>
        <layer id="2" name="empty" width="30" height="20"><data encoding="csv"></data></layer>
        <group name="g"><layer id="3" name="base" width="30" height="20"><data encoding="base64">
        <chunk x="-2" y="-3" width="3" height="2">AQAAAAAAAAADAAAAAgAAAAUAAAAIAAAA</chunk></data></layer></group>
        <objectgroup name="things"><object id="1" x="5" y="7"><point/></object></objectgroup>
        <imagelayer name="sky"><image source="sky.png"/></imagelayer>)";
    const TileMap map = good("i.tmx", infinite("orientation=\"orthogonal\"", layers));
    CHECK(map.columns == 4);
    CHECK(map.rows == 4);
    CHECK(ids(map.layers[0]) == std::vector<std::uint32_t>{1, 2, 0, 0, 3, 4, 0, 5, 0, 0, 0, 6, 0, 0, 0, 7});
    CHECK(ids(map.layers[1]) == std::vector<std::uint32_t>(16));
    CHECK(ids(map.layers[2]) == std::vector<std::uint32_t>{1, 0, 3, 0, 2, 5, 8, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    // The tile of the editor's (0, 0) is the third of the fourth row, and the object lies in it.
    CHECK(map.layers[3].objects[0].position == Vec2{5 + 2 * 16, 7 + 3 * 8});
    CHECK(map.layers[4].image_corner == Vec2{2 * 16, 3 * 8});
    CHECK(map.parallax_origin == Vec2{2 * 16, 3 * 8});

    const TileMap diamonds = good("d.tmx", infinite("orientation=\"isometric\"", layers));
    CHECK(diamonds.layers[3].objects[0].position == Vec2{5 + 2 * 8, 7 + 3 * 8});
    // The editor puts the top of its cell (0, 0) half a cell to the right of 20 rows: (160, 0) from the
    // picture.
    CHECK(diamonds.layers[4].image_corner + Vec2{160, 0} == diamonds.from_cells({2, 3}));

    // A staggered one begins at an even row and column, so that the same rows stay half a cell behind.
    const TileMap staggered =
        good("s.tmx", infinite("orientation=\"staggered\" staggeraxis=\"y\" staggerindex=\"odd\"", layers));
    CHECK(staggered.columns == 4);
    CHECK(staggered.rows == 5);
    CHECK(staggered.layers[0].tiles[4].id == 1);
    const Vec2 place = staggered.layers[3].objects[0].position;
    CHECK(place == Vec2{5 + 2 * 16, 7 + 4 * 4});
    CHECK(staggered.cell_at(place + Vec2{3, -3}) == TileMap::Cell{2, 4});  // the middle of (0, 0)

    const TileMap json =
        good("i.tmj", R"({"orientation": "orthogonal", "infinite": true, "width": 1, "height": 1,
        "tilewidth": 16, "tileheight": 8, "tilesets": [{"firstgid": 1, "source": "sets/ground.tsx"}], "layers": [
        {"type": "tilelayer", "name": "ground", "chunks": [{"x": -2, "y": -3, "width": 2, "height": 2, "data": [1, 2, 3, 4]},
        {"x": 1, "y": -2, "width": 1, "height": 3, "data": [5, 6, 7]}]}]})");
    CHECK(json.layers[0].tiles == map.layers[0].tiles);
}

TEST_CASE_METHOD(Maps, "objects of every shape, in groups too") {
    const TileMap map = good(
        "o.tmx",
        tmx(kCsv, R"(<group name="things" offsetx="3" opacity="0.5"><objectgroup name="objects" visible="0">
        <object id="4" name="door" class="exit" x="10" y="20" width="6" height="8" rotation="90">
        <properties><property name="to" value="cellar"/></properties></object>
        <object id="5" x="1" y="2" width="4" height="4"><ellipse/></object><object id="6" x="1" y="2"><point/></object>
        <object id="7" x="1" y="2"><polygon points="0,0 5,0 5,-7.5"/></object>
        <object id="8" x="1" y="2"><polyline points="0,0 1,1"/></object>
        <object id="9" gid="2147483651" x="16" y="32" width="16" height="16"/>
        <object id="10" x="0" y="0" width="9" height="9"><text>Hello</text></object></objectgroup></group>)"));
    const MapLayer* layer = map.layer("things/objects");
    REQUIRE(layer);
    CHECK(layer->kind == MapLayer::Kind::Objects);
    CHECK_FALSE(layer->is_visible);
    CHECK(layer->offset == Vec2{3, 0});
    CHECK(layer->color.a == 0.5f);
    REQUIRE(layer->objects.size() == 7);
    const MapObject& door = layer->objects[0];
    CHECK(door.name == "door");
    CHECK(door.kind == "exit");
    CHECK(door.shape == MapShape::Rectangle);
    CHECK(door.position == Vec2{10, 20});
    CHECK(door.size == Vec2{6, 8});
    CHECK(door.rotation_rad == Approx(3.14159265 / 2));
    CHECK(std::get<std::string>(door.properties.at("to")) == "cellar");
    CHECK(layer->objects[1].shape == MapShape::Ellipse);
    CHECK(layer->objects[2].shape == MapShape::Point);
    CHECK(layer->objects[3].points == std::vector<Vec2>{{0, 0}, {5, 0}, {5, -7.5f}});
    CHECK(layer->objects[4].shape == MapShape::Polyline);
    CHECK(layer->objects[5].tile == Tile{.id = 3, .flip_x = true});
    CHECK(layer->objects[6].text == "Hello");
}

TEST_CASE_METHOD(
    Maps, "objects that are tiles stand on the point that their set says, in its size if they say none") {
    const auto load_with = [&](const std::string& grid, const std::string& alignment) {
        return good("a.tmx", R"(<map orientation=")" + grid +
                                 R"(" width="3" height="2" tilewidth="16" tileheight="8">
        <tileset firstgid="1" name="t" tilewidth="12" tileheight="20" tilecount="1" columns="1")" +
                                 alignment + R"(><image source="t.png" width="12" height="20"/></tileset>
        <objectgroup name="o"><object id="1" gid="1" x="5" y="6"/>
        <object id="2" gid="1" x="5" y="6" width="30" height="0"/><object id="3" x="5" y="6"/></objectgroup></map>)");
    };
    const auto anchor = [&](const std::string& grid, const std::string& alignment) {
        const TileMap map = load_with(grid, alignment);
        const std::vector<MapObject>& objects = map.layers.at(0).objects;
        CHECK(objects.at(0).size == Vec2{12, 20});
        CHECK(objects.at(1).size == Vec2{30, 20});
        CHECK(objects.at(2).size == Vec2{0, 0});
        CHECK(objects.at(2).anchor == Vec2{0, 0});
        CHECK(objects.at(0).anchor == objects.at(1).anchor);
        return objects.at(0).anchor;
    };
    CHECK(anchor("orthogonal", "") == Vec2{0, 1});
    CHECK(anchor("isometric", "") == Vec2{0.5f, 1});
    CHECK(anchor("isometric", R"( objectalignment="unspecified")") == Vec2{0.5f, 1});
    const std::pair<const char*, Vec2> named[] = {
        {"topleft", {0, 0}},    {"top", {0.5f, 0}},       {"topright", {1, 0}},
        {"left", {0, 0.5f}},    {"center", {0.5f, 0.5f}}, {"right", {1, 0.5f}},
        {"bottomleft", {0, 1}}, {"bottom", {0.5f, 1}},    {"bottomright", {1, 1}}};
    for (const auto& [name, place] : named) {
        INFO(name);
        for (const char* grid : {"orthogonal", "isometric"})
            CHECK(anchor(grid, " objectalignment=\"" + std::string(name) + '"') == place);
    }
}

TEST_CASE_METHOD(Maps, "a tile set says how far from their places its tiles are drawn") {
    const auto offset = [&](const std::string& element) {
        return good("o.tmx",
                    R"(<map orientation="orthogonal" width="3" height="2" tilewidth="16" tileheight="8">
            <tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1">)" +
                        element + R"(<image source="t.png"/></tileset></map>)")
            .sets.at(0)
            .tile_offset;
    };
    CHECK(offset("") == Vec2{0, 0});
    CHECK(offset(R"(<tileoffset x="-3" y="5"/>)") == Vec2{-3, 5});
    CHECK(offset(R"(<tileoffset y="5"/>)") == Vec2{0, 5});
}
