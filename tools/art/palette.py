# The colours of the slingshot's world, in one place so that they stay in harmony: warm light, cool shade, and one
# dark brown for every outline. Each is (r, g, b), 0..1, sRGB.


def rgb(code):
    return tuple(int(code[i : i + 2], 16) / 255 for i in (0, 2, 4))


INK = rgb("4a3230")

SKY_TOP = rgb("6fb3d2")
SKY_MIDDLE = rgb("b5dbe0")
SKY_LOW = rgb("fdeccd")
SUN = rgb("fff6da")
CLOUD = rgb("fffaf0")
CLOUD_SHADE = rgb("d9e4e6")

FAR_HILL = rgb("a9cbc9")
FAR_HILL_LOW = rgb("c9dfd2")
MIDDLE_HILL = rgb("84b59c")
MIDDLE_HILL_LOW = rgb("abcfa9")
NEAR_HILL = rgb("6fa46f")
NEAR_HILL_LOW = rgb("97c07d")

GRASS_LIGHT = rgb("a8cf5f")
GRASS = rgb("7cb04b")
GRASS_DARK = rgb("538540")
EARTH = rgb("9a6b48")
EARTH_DARK = rgb("6d4738")
EARTH_STONE = rgb("b58b66")

WOOD = rgb("dca564")
WOOD_LIGHT = rgb("efc588")
WOOD_DARK = rgb("b87a42")
STONE = rgb("a9a6b3")
STONE_LIGHT = rgb("c6c3cc")
STONE_DARK = rgb("85818f")
ICE = rgb("b4e3f0")
ICE_LIGHT = rgb("e9fbff")
ICE_DARK = rgb("7cc3dd")

PEBBLE = rgb("8d8fa3")
PEBBLE_LIGHT = rgb("b6b8c6")
PEBBLE_DARK = rgb("66677d")
MOSS = rgb("8fb651")

TURNIP_TOP = rgb("a4508f")
TURNIP_MIDDLE = rgb("cf86b4")
TURNIP_LOW = rgb("fbeedd")
LEAF = rgb("6da33f")
LEAF_DARK = rgb("46752f")

FORK = rgb("9c6238")
FORK_LIGHT = rgb("c4874f")
FORK_DARK = rgb("6f4229")
BAND = rgb("8c3b34")
LEATHER = rgb("5c3a2c")

GOLD = rgb("ffc93c")
GOLD_DARK = rgb("e0932a")
EMPTY = rgb("d8c7ae")
CREAM = rgb("fff3dc")
