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
    const std::string start = "maps/w.tmj:";
    CHECK(read_tile_map(*files, "maps/w.tmj").faults ==
          std::vector<std::string>{
              start + "1: parallaxoriginx is true, but must be a number",
              start + "2: layer \"a\": image is missing, but must name the picture of the layer",
              start + "2: layer \"b\": image is 5, but must be a text",
              start + "3: layer \"g/c\": repeatx is 2, but must be true or false",
              start + "3: layer \"g/c\": repeaty is \"yes\", but must be true or false",
              start + "5: layer \"d\": transparentcolor is \"pink\", but must be a color like \"#rrggbb\"",
              start + "6: layer \"e\": opacity is 1.5, but must be from 0 to 1",
              start + "7: layer \"f\": parallaxx is \"far\", but must be a number",
              start + "8: layer \"g\": tintcolor is \"red\", but must be a color like \"#rrggbb\""});
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
               Catch::Contains("layer \"a\": chunks[1].x is 0.5, but must be a whole number"));
    CHECK_THAT(fault(R"({"x": 0, "y": 0, "width": 2, "height": 1, "data": [0]})"),
               Catch::Contains("layer \"a\": chunks[1]: data has 1 tiles, but there are 2 cells"));
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
    CHECK_THAT(message("<map"), Catch::StartsWith("maps/w.tmx:1: the XML is broken: "));
    CHECK_THAT(message("<game/>"), Catch::Contains("neither a <map> nor a <tileset>"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,3</data>"),
               Catch::StartsWith("maps/w.tmx:") &&
                   Catch::Contains("layer \"ground\": it has 3 tiles, but the layer has 6 cells"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,3,4,5,6,7</data>"), Catch::Contains("7 tiles"));
    CHECK_THAT(data("<data encoding=\"csv\">1,2,x,4,5,6</data>"),
               Catch::Contains("\"x,4,5,6\" is no tile number"));
    CHECK_THAT(data("<data encoding=\"csv\">1,\x7f\n\xff,3</data>"),
               Catch::Contains("\"\x7f\\n\xef\xbf\xbd,3\" is no tile number"));
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
               Catch::StartsWith(
                   "maps/w.tmx:4: tile set 'maps/sets/none.tsx': file 'maps/sets/none.tsx': not found"));
    CHECK_THAT(without("#ff8000", "#fg8000"), Catch::Contains("must be a color"));
    CHECK_THAT(load("w.tmj", "{").error().message, Catch::Contains("is not JSON"));
    CHECK(load("w.tmj", "[]").error().message == "maps/w.tmj: must be an object");
    CHECK_THAT(load("w.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1, "layers": [3]})")
                   .error()
                   .message,
               Catch::Contains("layers[1]: must be an object"));
    CHECK_THAT(load("w.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1})").error().message,
               Catch::StartsWith("maps/w.tmj:1: layers is missing, but must be a list"));
}

TEST_CASE_METHOD(Maps, "all that is wrong with a map is told at once, each fault with its place") {
    folder.put("maps/bad.tmj", R"({"width": 2, "height": 0, "tilewidth": 1.5, "tileheight": 1, "layers": [],
        "tilesets": [{"firstgid": 1, "name": 3, "tilewidth": 8, "tileheight": 8, "tilecount": 0, "columns": 2},
            {"firstgid": 1, "source": "none.tsx"}], "backgroundcolor": "red"})");
    const std::string start = "maps/bad.tmj:";
    CHECK(
        read_tile_map(*files, "maps/bad.tmj").faults ==
        std::vector<std::string>{
            start + "1: tilewidth is 1.5, but must be a whole number from 1 to 4096",
            start + "1: height is 0, but must be a whole number from 1 to 10000",
            start + "1: backgroundcolor is \"red\", but must be a color like \"#rrggbb\"",
            start + "2: tilesets[1].name is 3, but must be a text",
            start +
                "2: tilesets[1].image is missing, but must name the picture of all its tiles; sets of single "
                "pictures are not known",
            start + "2: tilesets[1].tilecount is 0, but must be a whole number from 1 to 16777216",
            start + "3: tile set 'maps/none.tsx': file 'maps/none.tsx': not found"});
    folder.put("maps/parts.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8, "layers": [
        {"type": "tilelayer", "name": "a", "data": [1]}, {"type": "sky", "name": "b"},
        {"type": "objectgroup", "name": "c", "objects": [{"x": 0}, {"x": 0, "y": 0}, {"x": 0, "y": 0, "gid": 9}]},
        {"type": "objectgroup", "name": "d"}]})");
    const std::string parts = "maps/parts.tmj:";
    CHECK(read_tile_map(*files, "maps/parts.tmj").faults ==
          std::vector<std::string>{
              parts + "2: layer \"a\": data has 1 tiles, but there are 2 cells",
              parts +
                  "2: layer \"b\": type is \"sky\", but must be a tilelayer, an objectgroup, a group or an "
                  "imagelayer",
              parts + "3: layer \"c\": objects[1].y is missing, but must be a number",
              parts + "3: layer \"c\": objects[3]: it has a tile 9 that no tile set has",
              parts + "4: layer \"d\": objects is missing, but must be a list"});
}

TEST_CASE_METHOD(Maps, "every fault of an object is told by the names that its author gave, and its line") {
    const std::string tmx_map = R"(<map width="0" height="1" tilewidth="8" tileheight="8">
 <group name="g"><objectgroup name="things">
  <object id="3" name="crate" x="nan" y="1e999" width="-inf" height="2" rotation="left">
   <properties><property name="mass" type="float" value="nan"/><property name="loot" value="gold"/>
    <property name="sensor" type="bool" value="yes"/></properties>
  </object>
  <object id="4" x="1"/>
  <object name="line" x="1" y="1"><polyline points="0,0 5,inf"/></object>
 </objectgroup></group>
</map>)";
    folder.put("maps/o.tmx", tmx_map);
    const TileMapReading reading = read_tile_map(*files, "maps/o.tmx");
    const std::string crate = "object 3 \"crate\" in layer \"g/things\": ";
    const std::string at = "maps/o.tmx:3: " + crate;
    CHECK(reading.faults ==
          std::vector<std::string>{
              "maps/o.tmx:1: width is 0.0, but must be a whole number from 1 to 10000",
              at + "x is \"nan\", but must be a number", at + "y is \"1e999\", but must be a number",
              at + "width is \"-inf\", but must be a number",
              at + "rotation is \"left\", but must be a number",
              "maps/o.tmx:4: " + crate +
                  "property \"mass\" is \"nan\", but must be a number: its type is float",
              "maps/o.tmx:5: " + crate +
                  "property \"sensor\" is \"yes\", but must be true or false: its type is bool",
              "maps/o.tmx:7: object 4 in layer \"g/things\": y is missing, but must be a number",
              "maps/o.tmx:8: object \"line\" in layer \"g/things\": polyline[2].y is \"inf\", but must be a "
              "number"});
    // What was good is there, and what was not is known.
    REQUIRE(reading.map.layers.size() == 1);
    const MapObject& object = reading.map.layers[0].objects.at(0);
    CHECK(object.size.y == 2);
    CHECK(object.properties == TileProperties{{"loot", std::string("gold")}});
    CHECK(object.unreadable == std::set<std::string, std::less<>>{"x", "y", "width", "rotation",
                                                                  "property mass", "property sensor"});
    CHECK(object.place == "object 3 \"crate\" in layer \"g/things\"");
    CHECK(object.line == 3);
    CHECK_FALSE(load_tile_map(*files, "maps/o.tmx"));
    // The same object in JSON, whose lines are those of its opening brackets.
    folder.put("maps/o.tmj", R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8,
 "layers": [ { "type": "objectgroup", "name": "things { \" [",
   "objects":[
     {"id": 3, "name": "crate", "x": null,
      "y": "far", "properties": [
        { "name": "mass",
          "value": "nan", "type": "float" }]}, {"id": 4, "x": 1, "y": []}] } ] })");
    const std::string json_crate = "object 3 \"crate\" in layer \"things { \" [\": ";
    CHECK(read_tile_map(*files, "maps/o.tmj").faults ==
          std::vector<std::string>{
              "maps/o.tmj:4: " + json_crate + "x is null, but must be a number",
              "maps/o.tmj:4: " + json_crate + "y is \"far\", but must be a number",
              "maps/o.tmj:6: " + json_crate +
                  "property \"mass\" is \"nan\", but must be a number: its type is float",
              "maps/o.tmj:7: object 4 in layer \"things { \" [\": y is a list, but must be a number"});
}

TEST_CASE_METHOD(Maps,
                 "an attribute of a layer that is wrong hides neither the others nor the objects in it") {
    folder.put("maps/l.tmx", R"(<map width="1" height="1" tilewidth="8" tileheight="8">
 <objectgroup name="a" opacity="2" tintcolor="red"><object id="1" x="0" y="up"/></objectgroup>
</map>)");
    const TileMapReading reading = read_tile_map(*files, "maps/l.tmx");
    CHECK(reading.faults ==
          std::vector<std::string>{
              "maps/l.tmx:2: layer \"a\": tintcolor is \"red\", but must be a color like \"#rrggbb\"",
              "maps/l.tmx:2: layer \"a\": opacity is 2.0, but must be from 0 to 1",
              "maps/l.tmx:2: object 1 in layer \"a\": y is \"up\", but must be a number"});
    CHECK_FALSE(reading.lacks_objects);
    folder.put("maps/n.tmj", R"({"width": 1, "height": 1, "tilewidth": 8, "tileheight": 8,
 "layers": [{"type": "objectgroup", "name": "a", "objects": {}}]})");
    CHECK(read_tile_map(*files, "maps/n.tmj").lacks_objects);
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
               Catch::StartsWith("maps/u.tmj:1: is not JSON: column 18: "));
    CHECK_THAT(fault("o.tmj", "{\"width\": 1e999}"),
               Catch::StartsWith("maps/o.tmj:1: is not JSON: column 15: number overflow"));
    CHECK_THAT(fault("s.tmj", "{\n\"width\": 1,\n\"height\" 2\n}"),
               Catch::StartsWith("maps/s.tmj:3: is not JSON: column 10: syntax error"));
    CHECK_THAT(fault("e.json", "{\n\"width\": tru\n}"),
               Catch::StartsWith("maps/e.json:2: is not JSON: column 13: "));
    CHECK_THAT(fault("l.tmj", "{\n\"width\": 1e999\n}"),
               Catch::StartsWith("maps/l.tmj:2: is not JSON: column 14: number overflow"));
    CHECK_THAT(fault("c.tmj", "{\n\"width\": 1,"), Catch::StartsWith("maps/c.tmj:2: is not JSON: column "));
    CHECK_THAT(fault("b.tmj", ""), Catch::StartsWith("maps/b.tmj:1: is not JSON: column 1: "));
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
                      .place = "w.tmx:4: tile set \"t\""};
    CHECK(set.check_image({29, 19}));
    CHECK(set.check_image({28, 19}).error().message ==
          "w.tmx:4: tile set \"t\": columns is 3, but must be at most 2: so many tiles of 8 x 8 fit into the "
          "picture "
          "'t.png' of "
          "28 x 19");
    CHECK(set.check_image({29, 18}).error().message ==
          "w.tmx:4: tile set \"t\": tilecount is 5, but must be at most 3: so many tiles of 8 x 8 fit into "
          "the picture "
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

TEST_CASE_METHOD(
    Maps,
    "tiles as objects that are smaller than nothing or huge are faults, as is an alignment of nowhere") {
    folder.put("maps/t.tmx",
               R"(<map orientation="orthogonal" width="3" height="2" tilewidth="16" tileheight="8">
<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1" objectalignment="middle">
 <image source="t.png" width="8" height="8"/></tileset>
<objectgroup name="o">
 <object id="1" name="crate" gid="1" x="0" y="0" width="-16" height="1000001"/>
 <object id="2" gid="1" x="0" y="0" width="1e39" height="nan"/>
 <object id="3" gid="1" x="0" y="0" width="1000000" height="16"/>
</objectgroup></map>)");
    const std::string rule = ", but must be from 0 to 1000000 for a tile";
    CHECK(read_tile_map(*files, "maps/t.tmx").faults ==
          std::vector<std::string>{
              "maps/t.tmx:2: tile set \"t\": objectalignment is \"middle\", but must be unspecified, "
              "topleft, top, "
              "topright, left, center, right, bottomleft, bottom or bottomright",
              "maps/t.tmx:5: object 1 \"crate\" in layer \"o\": width is -16.0" + rule,
              "maps/t.tmx:5: object 1 \"crate\" in layer \"o\": height is 1000001.0" + rule,
              "maps/t.tmx:6: object 2 in layer \"o\": height is \"nan\", but must be a number",
              "maps/t.tmx:6: object 2 in layer \"o\": width is 1e+39" + rule});
}
