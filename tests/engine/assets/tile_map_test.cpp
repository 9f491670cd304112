// Maps of Tiled in XML and JSON, every way to write tiles, and what can be wrong with them.
#include <catch2/catch.hpp>

#include <cairn/engine/random.h>
#include <cairn/engine/tile_map.h>

#include "engine/support/temporary_folder.h"

using namespace cairn::engine;

namespace {

struct Maps {
    Maps() {
        auto made = Files::create({});
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
    Result<TileMap> load(const std::string& name, const std::string& text) {
        folder.put("maps/" + name, text);
        return load_tile_map(*files, "maps/" + name);
    }
    TemporaryFolder folder;
    std::unique_ptr<Files> files;
};

/// A map of 3 x 2 cells of 16 pixels whose layer's data element is given.
std::string tmx(const std::string& data, const std::string& more = "") {
    return R"(<?xml version="1.0" encoding="UTF-8"?><map version="1.10" orientation="orthogonal" width="3" height="2"
        tilewidth="16" tileheight="16" infinite="0" backgroundcolor="#ff8000"><properties>
        <property name="title" value="7"/><property name="wind" type="float" value="0.5"/></properties>
        <tileset firstgid="1" source="sets/ground.tsx"/><layer id="1" name="ground" width="3" height="2" opacity="0.5">)" +
           data + "</layer>" + more + "</map>";
}

const char* kCsv = "<data encoding=\"csv\">\n1,0,3,\n2147483650,1610612741,8\n</data>";

std::vector<std::uint32_t> ids(const MapLayer& layer) {
    std::vector<std::uint32_t> all;
    for (const Tile& tile : layer.tiles) all.push_back(tile.id);
    return all;
}

}  // namespace

TEST_CASE_METHOD(Maps, "a map has its size, its sets, its layers and its properties") {
    const auto map = load("a.tmx", tmx(kCsv));
    if (!map) FAIL(map.error().message);
    CHECK(map->columns == 3);
    CHECK(map->rows == 2);
    CHECK(map->tile_size == Size{16, 16});
    CHECK(map->background == Color{1, 128 / 255.0f, 0, 1});
    CHECK(std::get<std::string>(map->properties.at("title")) == "7");
    CHECK(std::get<double>(map->properties.at("wind")) == 0.5);
    REQUIRE(map->sets.size() == 1);
    CHECK(map->sets[0].image_path == "art/ground.png");
    CHECK(map->sets[0].source(1) == Rect{1, 1, 16, 16});
    CHECK(map->sets[0].source(6) == Rect{19, 19, 16, 16});
    const MapLayer* ground = map->layer("ground");
    REQUIRE(ground);
    CHECK(ground->color == Color{1, 1, 1, 0.5f});
    CHECK(ids(*ground) == std::vector<std::uint32_t>{1, 0, 3, 2, 5, 8});
    CHECK(ground->tiles[3] == Tile{.id = 2, .flip_x = true});
    CHECK(ground->tiles[4] == Tile{.id = 5, .flip_y = true, .flip_diagonal = true});
}

TEST_CASE_METHOD(Maps, "tiles have properties, and animated ones show frame after frame") {
    const auto map = load("a.tmx", tmx(kCsv));
    REQUIRE(map);
    CHECK(std::get<bool>(map->properties_of(3).at("solid")));
    CHECK(std::get<std::string>(map->properties_of(3).at("class")) == "grass");
    CHECK(map->properties_of(1).empty());
    CHECK(map->properties_of(0).empty());
    CHECK(map->shown(6, 0.05) == 6);
    CHECK(map->shown(6, 0.15) == 7);
    CHECK(map->shown(6, 0.39) == 7);
    CHECK(map->shown(6, 0.45) == 6);
    CHECK(map->shown(3, 9) == 3);
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
        const auto map = load("b.tmx", tmx(data));
        if (!map) FAIL(map.error().message);
        CHECK(ids(map->layers[0]) == expected);
    }
}

TEST_CASE_METHOD(Maps, "elements for tiles keep their flags, and are counted and checked") {
    const auto map =
        load("e.tmx", tmx("<data><tile gid=\"2147483650\"/><tile/><tile/><tile/><tile/><tile/></data>"));
    REQUIRE(map);
    CHECK(map->layers[0].tiles[0] == Tile{.id = 2, .flip_x = true});
    CHECK_THAT(load("e.tmx", tmx("<data><tile gid=\"1\"/></data>")).error().message,
               Catch::Contains("data has 1 tiles, but there are 6 cells"));
    CHECK_THAT(load("e.tmx", tmx("<data><tile gid=\"-1\"/></data>")).error().message,
               Catch::Contains("must hold tile numbers"));
}

TEST_CASE_METHOD(Maps, "image layers have their picture and what is done to it, in XML and in JSON") {
    const auto xml = load(
        "i.tmx", tmx(kCsv, R"(<group name="far" offsetx="5" offsety="-2" opacity="0.5" tintcolor="#ff8000"
        parallaxx="0.5" visible="0"><imagelayer name="sky" offsetx="1" opacity="0.5" tintcolor="#80ffffff" parallaxx="0.5"
        parallaxy="0.25" repeatx="1"><image source="../art/sky.png" width="64" height="32"/></imagelayer></group>
        <imagelayer name="near" repeatx="0" repeaty="1"><image source="near.png"/></imagelayer>)"));
    if (!xml) FAIL(xml.error().message);
    const auto json = load(
        "i.tmj", R"({"orientation": "orthogonal", "width": 3, "height": 2, "tilewidth": 16, "tileheight": 16,
        "tilesets": [], "layers": [{"type": "group", "name": "far", "offsetx": 5, "offsety": -2, "opacity": 0.5,
        "tintcolor": "#ff8000", "parallaxx": 0.5, "visible": false, "layers": [{"type": "imagelayer", "name": "sky", "offsetx": 1,
        "opacity": 0.5, "tintcolor": "#80ffffff", "parallaxx": 0.5, "parallaxy": 0.25, "repeatx": true,
        "image": "../art/sky.png"}]}, {"type": "imagelayer", "name": "near", "repeaty": true, "image": "near.png"}]})");
    if (!json) FAIL(json.error().message);
    for (const TileMap& map : {*xml, *json}) {
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

TEST_CASE_METHOD(Maps, "what is wrong with an image layer is told with its place") {
    folder.put("maps/w.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8, "layers": [
        {"type": "imagelayer", "name": "a"}, {"type": "imagelayer", "name": "b", "image": 5},
        {"type": "group", "name": "g", "layers": [{"type": "imagelayer", "name": "c", "image": "c.png", "repeatx": 2,
         "repeaty": "yes"}]},
        {"type": "imagelayer", "name": "d", "image": "d.png", "transparentcolor": "pink"},
        {"type": "imagelayer", "name": "e", "image": "e.png", "opacity": 1.5},
        {"type": "imagelayer", "name": "f", "image": "f.png", "parallaxx": "far"},
        {"type": "imagelayer", "name": "g", "image": "g.png", "tintcolor": "red"}], "parallaxoriginx": true})");
    const std::string start = "map 'maps/w.tmj': ";
    CHECK(read_tile_map(*files, "maps/w.tmj").faults ==
          std::vector<std::string>{
              start + "parallaxoriginx is true, but must be a number",
              start + "layers[1].image is missing, but must name the picture of the layer",
              start + "layers[2].image is 5, but must be a text",
              start + "layers[3].layers[1].repeatx is 2, but must be true or false",
              start + "layers[3].layers[1].repeaty is \"yes\", but must be true or false",
              start + "layers[4].transparentcolor is \"pink\", but must be a color like \"#rrggbb\"",
              start + "layers[5].opacity is 1.5, but must be from 0 to 1",
              start + "layers[6].parallaxx is \"far\", but must be a number",
              start + "layers[7].tintcolor is \"red\", but must be a color like \"#rrggbb\""});
}

TEST_CASE_METHOD(Maps, "the transparent color of a picture is that of its tile set or layer") {
    const auto xml =
        load("t.tmx", R"(<map width="1" height="1" tilewidth="8" tileheight="8"><tileset firstgid="1" name="a"
        tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="a.png" trans="ff8000"/></tileset>
        <tileset firstgid="2" name="b" tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="b.png"/></tileset>
        <imagelayer name="c"><image source="c.png" trans="#000000"/></imagelayer></map>)");
    if (!xml) FAIL(xml.error().message);
    const std::string set =
        R"("tilewidth": 8, "tileheight": 8, "tilecount": 1, "columns": 1, "image": "a.png")";
    const auto json =
        load("t.tmj", R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8, "tilesets": [
        {"firstgid": 1, "transparentcolor": "#ff8000", )" +
                          set + R"(}, {"firstgid": 2, )" + set + R"(}],
        "layers": [{"type": "imagelayer", "name": "c", "image": "c.png", "transparentcolor": "#000000"}]})");
    if (!json) FAIL(json.error().message);
    for (const TileMap& map : {*xml, *json}) {
        REQUIRE(map.sets.size() == 2);
        CHECK(map.sets[0].transparent == Color{1, 128 / 255.0f, 0, 1});
        CHECK_FALSE(map.sets[1].transparent);
        CHECK(map.layers[0].transparent == Color{0, 0, 0, 1});
    }
    folder.put("maps/w.tmj",
               R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8, "layers": [], "tilesets": [
        {"firstgid": 1, "transparentcolor": 7, )" +
                   set + "}]}");
    CHECK(
        read_tile_map(*files, "maps/w.tmj").faults ==
        std::vector<std::string>{"map 'maps/w.tmj': tilesets[1].transparentcolor is 7, but must be a text"});
}

// "The parallax scrolling factor is applied based on the distance of the center of the view from the parallax
// origin": at 1 a layer moves with the map, at 0 with the view, at 0.5 half as much.
TEST_CASE_METHOD(Maps, "parallax moves layers by their factors with the middle of the view") {
    const auto map =
        load("p.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8, "parallaxoriginx": 10,
        "parallaxoriginy": -4, "layers": [
        {"type": "imagelayer", "name": "near", "image": "a.png"},
        {"type": "imagelayer", "name": "far", "image": "a.png", "parallaxx": 0.5, "parallaxy": 2},
        {"type": "imagelayer", "name": "fixed", "image": "a.png", "parallaxx": 0, "parallaxy": 0}]})");
    if (!map) FAIL(map.error().message);
    for (const MapLayer& layer : map->layers) CHECK(map->parallax_shift(layer, {10, -4}) == Vec2{0, 0});
    CHECK(map->parallax_shift(map->layers[0], {50, 16}) == Vec2{0, 0});
    CHECK(map->parallax_shift(map->layers[1], {50, 16}) == Vec2{20, -20});
    CHECK(map->parallax_shift(map->layers[2], {50, 16}) == Vec2{40, 20});
}

TEST_CASE_METHOD(Maps, "JSON says the same as XML") {
    const std::string set =
        R"({"firstgid": 1, "name": "ground", "tilewidth": 16, "tileheight": 16, "tilecount": 8,
        "columns": 4, "margin": 1, "spacing": 2, "image": "../art/ground.png",
        "tiles": [{"id": 2, "type": "grass", "properties": [{"name": "solid", "type": "bool", "value": true}]}]})";
    const auto json =
        load("a.tmj", R"({"orientation": "orthogonal", "infinite": false, "width": 3, "height": 2,
        "tilewidth": 16, "tileheight": 16, "backgroundcolor": "#ff8000", "tilesets": [)" +
                          set +
                          R"(], "layers": [{"type": "tilelayer", "name": "ground", "opacity": 0.5,
        "data": [1, 0, 3, 2147483650, 1610612741, 8]}]})");
    if (!json) FAIL(json.error().message);
    const auto xml = load("a.tmx", tmx(kCsv));
    REQUIRE(xml);
    CHECK(json->layers[0].tiles == xml->layers[0].tiles);
    CHECK(json->layers[0].color == xml->layers[0].color);
    CHECK(json->sets[0].image_path == xml->sets[0].image_path);
    CHECK(json->properties_of(3) == xml->properties_of(3));
    CHECK(json->background == xml->background);
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
    const auto map = load("i.tmx", infinite("orientation=\"orthogonal\"", layers));
    if (!map) FAIL(map.error().message);
    CHECK(map->columns == 4);
    CHECK(map->rows == 4);
    CHECK(ids(map->layers[0]) == std::vector<std::uint32_t>{1, 2, 0, 0, 3, 4, 0, 5, 0, 0, 0, 6, 0, 0, 0, 7});
    CHECK(ids(map->layers[1]) == std::vector<std::uint32_t>(16));
    CHECK(ids(map->layers[2]) == std::vector<std::uint32_t>{1, 0, 3, 0, 2, 5, 8, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    // The tile of the editor's (0, 0) is the third of the fourth row, and the object lies in it.
    CHECK(map->layers[3].objects[0].position == Vec2{5 + 2 * 16, 7 + 3 * 8});
    CHECK(map->layers[4].image_corner == Vec2{2 * 16, 3 * 8});
    CHECK(map->parallax_origin == Vec2{2 * 16, 3 * 8});

    const auto diamonds = load("d.tmx", infinite("orientation=\"isometric\"", layers));
    REQUIRE(diamonds);
    CHECK(diamonds->layers[3].objects[0].position == Vec2{5 + 2 * 8, 7 + 3 * 8});
    // The editor puts the top of its cell (0, 0) half a cell to the right of 20 rows: (160, 0) from the
    // picture.
    CHECK(diamonds->layers[4].image_corner + Vec2{160, 0} == diamonds->from_cells({2, 3}));

    // A staggered one begins at an even row and column, so that the same rows stay half a cell behind.
    const auto staggered =
        load("s.tmx", infinite("orientation=\"staggered\" staggeraxis=\"y\" staggerindex=\"odd\"", layers));
    REQUIRE(staggered);
    CHECK(staggered->columns == 4);
    CHECK(staggered->rows == 5);
    CHECK(staggered->layers[0].tiles[4].id == 1);
    const Vec2 place = staggered->layers[3].objects[0].position;
    CHECK(place == Vec2{5 + 2 * 16, 7 + 4 * 4});
    CHECK(staggered->cell_at(place + Vec2{3, -3}) == TileMap::Cell{2, 4});  // the middle of (0, 0)

    const auto json =
        load("i.tmj", R"({"orientation": "orthogonal", "infinite": true, "width": 1, "height": 1,
        "tilewidth": 16, "tileheight": 8, "tilesets": [{"firstgid": 1, "source": "sets/ground.tsx"}], "layers": [
        {"type": "tilelayer", "name": "ground", "chunks": [{"x": -2, "y": -3, "width": 2, "height": 2, "data": [1, 2, 3, 4]},
        {"x": 1, "y": -2, "width": 1, "height": 3, "data": [5, 6, 7]}]}]})");
    if (!json) FAIL(json.error().message);
    CHECK(json->layers[0].tiles == map->layers[0].tiles);
}

TEST_CASE_METHOD(Maps, "what is wrong with the chunks of an infinite map is told with its place") {
    const auto fault = [&](const std::string& chunks) {
        const auto map =
            load("w.tmj", R"({"orientation": "orthogonal", "infinite": true, "width": 1, "height": 1,
            "tilewidth": 16, "tileheight": 8, "layers": [{"type": "tilelayer", "name": "a", "chunks": [)" +
                              chunks + "]}]}");
        return map ? std::string() : map.error().message;
    };
    CHECK(fault("").empty());
    CHECK_THAT(fault(R"({"x": 0.5, "y": 0, "width": 1, "height": 1, "data": [0]})"),
               Catch::Contains("layers[1].chunks[1].x is 0.5, but must be a whole number"));
    CHECK_THAT(fault(R"({"x": 0, "y": 0, "width": 2, "height": 1, "data": [0]})"),
               Catch::Contains("layers[1].chunks[1]: data has 1 tiles, but there are 2 cells"));
    CHECK_THAT(fault(R"({"x": 0, "y": 0, "width": 1, "height": 1, "data": [0]},
                        {"x": 99999, "y": 0, "width": 1, "height": 1, "data": [0]})"),
               Catch::Contains("100000 x 1 tiles large, but must be at most 10000"));
}

TEST_CASE_METHOD(Maps, "objects of every shape, in groups too") {
    const auto map = load(
        "o.tmx",
        tmx(kCsv, R"(<group name="things" offsetx="3" opacity="0.5"><objectgroup name="objects" visible="0">
        <object id="4" name="door" class="exit" x="10" y="20" width="6" height="8" rotation="90">
        <properties><property name="to" value="cellar"/></properties></object>
        <object id="5" x="1" y="2" width="4" height="4"><ellipse/></object><object id="6" x="1" y="2"><point/></object>
        <object id="7" x="1" y="2"><polygon points="0,0 5,0 5,-7.5"/></object>
        <object id="8" x="1" y="2"><polyline points="0,0 1,1"/></object>
        <object id="9" gid="2147483651" x="16" y="32" width="16" height="16"/>
        <object id="10" x="0" y="0" width="9" height="9"><text>Hello</text></object></objectgroup></group>)"));
    if (!map) FAIL(map.error().message);
    const MapLayer* layer = map->layer("things/objects");
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

TEST_CASE_METHOD(Maps, "a wrong map is an error that names the file, the place and the rule") {
    const auto message = [&](const std::string& text) {
        const auto map = load("w.tmx", text);
        return map ? "" : map.error().message;
    };
    const auto data = [&](const std::string& d) { return message(tmx(d)); };
    CHECK_THAT(load_tile_map(*files, "none.tmx").error().message,
               Catch::Contains("'none.tmx'") && Catch::Contains("not found"));
    CHECK_THAT(message("<map"),
               Catch::Contains("maps/w.tmx") && Catch::Contains("the XML is broken at byte"));
    CHECK_THAT(message("<game/>"), Catch::Contains("neither a <map> nor a <tileset>"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,3</data>"),
               Catch::Contains("layers[1]") && Catch::Contains("3 tiles, but the layer has 6 cells"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,3,4,5,6,7</data>"), Catch::Contains("7 tiles"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,x,4,5,6</data>"),
               Catch::Contains("'x,4,5,6' is no tile number"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,9,4,5,6</data>"),
               Catch::Contains("a tile 9 that no tile set has"));
    CHECK_THAT(data("<data encoding=\"base64\">!!!!</data>"), Catch::Contains("no letter of base64"));
    CHECK_THAT(data("<data encoding=\"base64\" compression=\"zlib\">AAAA</data>"),
               Catch::Contains("damaged"));
    CHECK_THAT(data("<data encoding=\"base64\" compression=\"zstd\">AAAA</data>"),
               Catch::Contains("save it as CSV"));
    CHECK_THAT(data("<data encoding=\"morse\">AAAA</data>"),
               Catch::Contains("encoding is \"morse\", but must be csv or base64"));
    const auto without = [&](const std::string& from, const std::string& to) {
        std::string text = tmx(kCsv);
        return message(text.replace(text.find(from), from.size(), to));
    };
    CHECK_THAT(without("orthogonal", "oblique"),
               Catch::Contains("orientation is \"oblique\", but must be orthogonal, isometric, staggered or "
                               "hexagonal"));
    CHECK_THAT(without("infinite=\"0\"", "infinite=\"1\""), Catch::Contains("must stand in chunks"));
    CHECK_THAT(without("width=\"3\"", "width=\"0\""),
               Catch::Contains("width is 0.0, but must be a whole number from 1"));
    CHECK_THAT(without("width=\"3\"", "width=\"x\""),
               Catch::Contains("width is \"x\", but must be a number"));
    CHECK_THAT(without("sets/ground.tsx", "sets/none.tsx"),
               Catch::Contains("the tile set 'maps/sets/none.tsx'"));
    CHECK_THAT(without("#ff8000", "#fg8000"), Catch::Contains("must be a color"));
    CHECK_THAT(load("w.tmj", "{").error().message, Catch::Contains("is not JSON"));
    CHECK(load("w.tmj", "[]").error().message == "map 'maps/w.tmj': must be an object");
    CHECK_THAT(load("w.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1, "layers": [3]})")
                   .error()
                   .message,
               Catch::Contains("layers[1]: must be an object"));
    CHECK_THAT(load("w.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1})").error().message,
               Catch::Contains("maps/w.tmj': layers is missing, but must be a list"));
}

TEST_CASE_METHOD(Maps, "all that is wrong with a map is told at once, each fault with its place") {
    folder.put("maps/bad.tmj", R"({"width": 2, "height": 0, "tilewidth": 1.5, "tileheight": 1, "layers": [],
        "tilesets": [{"firstgid": 1, "name": 3, "tilewidth": 8, "tileheight": 8, "tilecount": 0, "columns": 2},
            {"firstgid": 1, "source": "none.tsx"}], "backgroundcolor": "red"})");
    const std::string start = "map 'maps/bad.tmj': ";
    CHECK(read_tile_map(*files, "maps/bad.tmj").faults ==
          std::vector<std::string>{
              start + "tilewidth is 1.5, but must be a whole number from 1 to 4096",
              start + "height is 0, but must be a whole number from 1 to 10000",
              start + "backgroundcolor is \"red\", but must be a color like \"#rrggbb\"",
              start + "tilesets[1].name is 3, but must be a text",
              start +
                  "tilesets[1].image is missing, but must name the picture of all its tiles; sets of single "
                  "pictures are not known",
              start + "tilesets[1].tilecount is 0, but must be a whole number from 1 to 16777216",
              start + "the tile set 'maps/none.tsx': file 'maps/none.tsx': not found"});
    folder.put("maps/parts.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8, "layers": [
        {"type": "tilelayer", "name": "a", "data": [1]}, {"type": "sky", "name": "b"},
        {"type": "objectgroup", "name": "c", "objects": [{"x": 0}, {"x": 0, "y": 0}, {"x": 0, "y": 0, "gid": 9}]},
        {"type": "objectgroup", "name": "d"}]})");
    const std::string parts = "map 'maps/parts.tmj': layers[";
    CHECK(read_tile_map(*files, "maps/parts.tmj").faults ==
          std::vector<std::string>{
              parts + "1]: data has 1 tiles, but there are 2 cells",
              parts + "2].type is \"sky\", but must be a tilelayer, an objectgroup, a group or an imagelayer",
              parts + "3].objects[1].y is missing, but must be a number",
              parts + "3].objects[3]: it has a tile 9 that no tile set has",
              parts + "4].objects is missing, but must be a list"});
}

TEST_CASE_METHOD(Maps, "bytes that are no text, numbers beyond all and endless nesting are faults of a map") {
    const auto fault = [&](const std::string& name, const std::string& text) {
        const auto map = load(name, text);
        REQUIRE_FALSE(map);
        return map.error().message;
    };
    CHECK_THAT(fault("u.tmx",
                     "<map orientation=\"ortho\xf6\" width=\"1\" height=\"1\" tilewidth=\"8\" "
                     "tileheight=\"8\"></map>"),
               Catch::Contains("orientation is \"ortho\xef\xbf\xbd\", but must be orthogonal"));
    CHECK_THAT(fault("u.tmj", "{\"orientation\": \"\xff\"}"),
               Catch::Contains("is not JSON: parse error at line 1"));
    CHECK_THAT(fault("o.tmj", "{\"width\": 1e999}"), Catch::Contains("is not JSON: number overflow"));
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += text;
        return all;
    };
    constexpr int kMany = 100'000;
    const std::string head = "<map width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">";
    CHECK_THAT(fault("n.tmx", head + repeated("<group>", kMany) + repeated("</group>", kMany) + "</map>"),
               Catch::Contains("the XML is nested more than 200 deep"));
    CHECK_THAT(fault("n.tmj", "{\"width\":" + repeated("[", kMany) + repeated("]", kMany) + "}"),
               Catch::Contains("is nested more than 200 deep"));
    // As deep as anybody goes is fine, and brackets in texts are no nesting.
    CHECK(load("d.tmx", head + repeated("<group>", 50) + repeated("</group>", 50) + "</map>"));
    CHECK(load("t.tmj",
               R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8, "layers": [], "x": "\"[)" +
                   repeated("[", kMany) + "\"}"));
}

TEST_CASE("a picture must have room for the tiles that a set says") {
    // 3 tiles in a row take 1 + 3 * 8 + 2 * 2 pixels, 2 rows 1 + 2 * 8 + 2.
    const TileSet set{.tile_count = 5,
                      .tile_size = {8, 8},
                      .columns = 3,
                      .margin = 1,
                      .spacing = 2,
                      .image_path = "t.png",
                      .place = "tilesets[2]"};
    CHECK(set.check_image({29, 19}));
    CHECK(set.check_image({28, 19}).error().message ==
          "tilesets[2].columns is 3, but must be at most 2: so many tiles of 8 x 8 fit into the picture "
          "'t.png' of "
          "28 x 19");
    CHECK(set.check_image({29, 18}).error().message ==
          "tilesets[2].tilecount is 5, but must be at most 3: so many tiles of 8 x 8 fit into the picture "
          "'t.png' "
          "of 29 x 18");
    CHECK_FALSE(set.check_image({1, 1}));
}

TEST_CASE_METHOD(Maps, "a map cut off anywhere is an error and no crash") {
    const std::string whole =
        tmx(kCsv, "<objectgroup name=\"o\"><object id=\"1\" x=\"1\" y=\"1\"/></objectgroup>");
    for (std::size_t length = 0; length < whole.size(); length += 7)
        CHECK_FALSE(load("c.tmx", whole.substr(0, length)));
}

TEST_CASE_METHOD(Maps, "the cells of an isometric map are diamonds, and its objects lie along their sides") {
    const auto map = load("iso.tmj", R"({"orientation": "isometric", "width": 3, "height": 2, "tilewidth": 32,
        "tileheight": 16, "layers": []})");
    if (!map) FAIL(map.error().message);
    CHECK(map->size() == Vec2{80, 40});
    CHECK(map->from_cells({0, 0}) == Vec2{32, 0});   // the top
    CHECK(map->from_cells({3, 0}) == Vec2{80, 24});  // the right corner
    CHECK(map->from_cells({0, 2}) == Vec2{0, 16});   // the left one
    CHECK(map->from_cells({3, 2}) == Vec2{48, 40});  // the bottom
    CHECK(map->from_object({48, 0}) == map->from_cells({3, 0}));
    CHECK(map->tile_corner(0, 0) == Vec2{16, 16});
    for (const Vec2 cells : {Vec2{0.5f, 0.25f}, Vec2{2, 1.5f}, Vec2{-3, 7}})
        CHECK(map->to_cells(map->from_cells(cells)) == cells);
}

TEST_CASE_METHOD(Maps, "hexagons and staggered diamonds lie where Tiled draws them") {
    const auto hexagons = load("hex.tmj", R"({"orientation": "hexagonal", "width": 3, "height": 3,
        "tilewidth": 14, "tileheight": 12, "hexsidelength": 6, "staggeraxis": "y", "staggerindex": "odd", "layers": []})");
    if (!hexagons) FAIL(hexagons.error().message);
    CHECK(hexagons->size() == Vec2{49, 30});
    CHECK(hexagons->cell_middle(0, 0) == Vec2{7, 6});
    CHECK(hexagons->cell_middle(0, 1) == Vec2{14, 15});
    CHECK(hexagons->cell_middle(2, 2) == Vec2{35, 24});
    CHECK(hexagons->tile_corner(0, 1) == Vec2{7, 21});
    CHECK(hexagons->cell_outline().size() == 6);
    CHECK(hexagons->cell_outline()[1] == Vec2{7, -3});
    const auto diamonds = load("staggered.tmj", R"({"orientation": "staggered", "width": 4, "height": 2,
        "tilewidth": 32, "tileheight": 16, "staggeraxis": "x", "staggerindex": "even", "layers": []})");
    if (!diamonds) FAIL(diamonds.error().message);
    CHECK(diamonds->size() == Vec2{80, 40});
    CHECK(diamonds->cell_middle(0, 0) == Vec2{16, 16});
    CHECK(diamonds->cell_middle(1, 0) == Vec2{32, 8});
    CHECK(diamonds->cell_outline().size() == 4);
    CHECK_THAT(load("bad.tmj", R"({"orientation": "hexagonal", "width": 3, "height": 3, "tilewidth": 14,
        "tileheight": 12, "hexsidelength": 12})")
                   .error()
                   .message,
               Catch::Contains("hexsidelength is 12, but must be a whole number from 0 to 11"));
    CHECK_THAT(load("bad.tmj", R"({"orientation": "staggered", "width": 3, "height": 3, "tilewidth": 14,
        "tileheight": 12, "staggeraxis": "z"})")
                   .error()
                   .message,
               Catch::Contains("staggeraxis is \"z\", but must be x or y"));
}

TEST_CASE_METHOD(Maps, "a place is in the cell whose outline holds it, on each kind of grid") {
    Random random(5);
    for (const char* orientation : {"orthogonal", "isometric", "staggered", "hexagonal"}) {
        for (const char* axis : {"x", "y"}) {
            for (const char* index : {"even", "odd"}) {
                const auto map = load("m.tmj", std::string(R"({"width": 9, "height": 8, "tilewidth": 18,
                    "tileheight": 14, "hexsidelength": 5, "orientation": ")") +
                                                   orientation + R"(", "staggeraxis": ")" + axis +
                                                   R"(", "staggerindex": ")" + index + R"(", "layers": []})");
                if (!map) FAIL(map.error().message);
                const std::vector<Vec2> outline = map->cell_outline();
                for (int i = 0; i < 500; ++i) {
                    const Vec2 place = {static_cast<float>(random.uniform(-60, 300)),
                                        static_cast<float>(random.uniform(-60, 300))};
                    const TileMap::Cell cell = map->cell_at(place);
                    const Vec2 from_middle = place - map->cell_middle(cell.column, cell.row);
                    bool is_inside = true;
                    for (std::size_t k = 0; k < outline.size(); ++k) {
                        const Vec2 edge = outline[(k + 1) % outline.size()] - outline[k];
                        const Vec2 way = from_middle - outline[k];
                        const float turn = edge.x * way.y - edge.y * way.x;
                        const Vec2 inward = Vec2{0, 0} - outline[k];
                        const float side = edge.x * inward.y - edge.y * inward.x;
                        is_inside = is_inside && turn * (side > 0 ? 1.0f : -1.0f) >= -0.01f;
                    }
                    INFO(orientation << ' ' << axis << ' ' << index << ' ' << place.x << ' ' << place.y);
                    REQUIRE(is_inside);
                    const Vec2 middle = map->cell_middle(cell.column, cell.row);
                    REQUIRE(map->cell_at(middle) == cell);
                }
            }
        }
    }
}

TEST_CASE("rectangles cover exactly the solid cells, each once, and runs with one rectangle") {
    CHECK(cover_cells(4, 3, std::vector<bool>(12, true)) == std::vector<CellRect>{{0, 0, 4, 3}});
    CHECK(cover_cells(3, 2, std::vector<bool>(6, false)).empty());
    Random random(3);
    for (int round = 0; round < 50; ++round) {
        constexpr int kColumns = 17, kRows = 9;
        std::vector<bool> solid;
        for (int i = 0; i < kColumns * kRows; ++i) solid.push_back(random.uniform() < 0.6);
        std::vector<int> covered(solid.size(), 0);
        for (const CellRect& r : cover_cells(kColumns, kRows, solid))
            for (int y = r.row; y < r.row + r.rows; ++y)
                for (int x = r.column; x < r.column + r.columns; ++x) ++covered[y * kColumns + x];
        for (std::size_t i = 0; i < solid.size(); ++i) REQUIRE(covered[i] == (solid[i] ? 1 : 0));
    }
}
