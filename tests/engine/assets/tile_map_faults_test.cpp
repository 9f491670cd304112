// What can be wrong with maps of Tiled, and how it is told.
#include <catch2/catch.hpp>

#include "engine/support/maps.h"

using namespace cairn::engine;

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
