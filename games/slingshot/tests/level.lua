-- Levels stand until they are shot at, and a match takes the course that the rules say.

local test = cairn.test

local MILLIMETRE = 0.001

--- Throws the loaded pebble with a pull, as if by mouse, and waits for the next one or the end.
local function shoot(match, pull_x, pull_y)
    match.slingshot:set_pull(pull_x, pull_y)
    match:shoot()
    test.expect_equal(match.phase, "flying")
    test.expect(test.run_until(function() return match.phase ~= "flying" end, 700))
end

test.test("the level stands untouched: still after 2 s, and asleep", function()
    test.start{}
    local match = require("src.game").match
    test.run(120)
    local places = {}
    for i, body in ipairs(match.world:bodies()) do
        places[i] = { body:position() }
    end
    test.run(240)
    test.expect_equal(match.world:awake_count(), 0)
    test.expect_equal(#match.pieces, #match.level.pieces)
    for i, body in ipairs(match.world:bodies()) do
        local x, y = body:position()
        test.expect_near(x, places[i][1], MILLIMETRE)
        test.expect_near(y, places[i][2], MILLIMETRE)
    end
    for _, body in ipairs(match.pieces) do
        test.expect_equal(body.data.health, 1)
    end
    test.expect_equal(match.phase, "aiming")
    test.expect_equal(match.points, 0)
end)

test.test("the level has what it takes: 12 pieces or more of three materials, 2 grumps, 3 shots", function()
    local level = require("src.level").load("level-01")
    test.expect(#level.pieces >= 12)
    test.expect_equal(#level.grumps, 2)
    test.expect_equal(level.shots, 3)
    local used = {}
    for _, piece in ipairs(level.pieces) do
        used[piece.material] = true
    end
    test.expect(used.wood and used.stone and used.ice)
    test.expect(level.stars.two < level.stars.three)
end)

--- The level with one field of its own replaced.
local function level_with(name, value)
    local level = require "src.level"
    local changed = level.load("level-01")
    changed.id = nil
    changed[name] = value
    return function() return cairn.data.check(changed, level.schema) end
end

test.test("stars that ask for more points for two than for three are refused, equal ones are not", function()
    test.expect_error(level_with("stars", { two = 15001, three = 15000 }),
        "stars: two = 15001 must not be above three = 15000")
    test.expect_equal(level_with("stars", { two = 15000, three = 15000 })().stars.two, 15000)
end)

test.test("texts that are not UTF-8 are refused", function()
    test.expect_error(level_with("name", "Gate\xffhouse"), "must be valid UTF-8; byte 5 is not")
    test.expect_error(level_with("hint", "\xc3"), "must be valid UTF-8; byte 1 is not")
    test.expect_equal(level_with("name", "Türme")().name, "Türme")
end)

test.test("a pebble flies along the dots of the preview", function()
    test.start{}
    local match = require("src.game").match
    match.slingshot:set_pull(-0.9, -0.5)
    local dots = {}
    match.slingshot:preview(match.GRAVITY, 0.1, 8, function(x, y, i) dots[i] = { x, y } end)
    match:shoot()
    for i = 1, 8 do
        test.run(6)
        local x, y = match.pebble:position()
        test.expect_near(x, dots[i][1], 2 * MILLIMETRE)
        test.expect_near(y, dots[i][2], 2 * MILLIMETRE)
    end
end)

test.test("three misses lose", function()
    test.start{}
    local match = require("src.game").match
    for _ = 1, 3 do
        test.expect_equal(match.phase, "aiming")
        shoot(match, 1.2, -0.8)
    end
    test.expect_equal(match.phase, "lost")
    test.expect_equal(match.stars, 0)
    local result = test.result()
    test.expect_equal(result.outcome, "lost")
    test.expect_equal(result.level, "level-01")
    test.expect_equal(result.stars, 0)
end)

test.test("a grump that leaves the level is gone, and without grumps the match is won", function()
    test.start{}
    local match = require("src.game").match
    for _, grump in ipairs(match.world:bodies()) do
        if grump.data.kind == "grump" then
            grump:set_position(100, 5)
        end
    end
    test.expect(test.run_until(function() return match:is_over() end, 300))
    test.expect_equal(match.phase, "won")
    local score = require "src.score"
    test.expect_equal(match.points, 2 * score.GRUMP + 3 * score.SPARE_SHOT)
    test.expect_equal(test.result().score, match.points)
end)

test.test("nothing counts after the end: neither the points nor the grumps left change", function()
    test.start{}
    local match = require("src.game").match
    for _ = 1, 3 do
        shoot(match, 1.2, -0.8)
    end
    test.expect_equal(match.phase, "lost")
    local points, popups = match.points, #match.effects.popups
    test.expect_equal(match.grumps_left, 2)
    for _, body in ipairs(match.world:bodies()) do
        if body.data.kind == "grump" then
            body:set_position(100, 5)
        end
    end
    match:break_piece(match.pieces[1])
    test.run(1)
    test.expect_equal(#match.grumps, 0)
    test.expect_equal(#match.effects.popups, popups)
    test.run(300)
    test.expect_equal(match.phase, "lost")
    test.expect_equal(match.points, points)
    test.expect_equal(match.grumps_left, 2)
    test.expect_equal(test.result().score, points)
end)

test.test("a restart gives the state of a fresh start", function()
    test.start{ seed = 7 }
    local game = require "src.game"
    test.run(30)
    local fresh = test.state_hash()
    shoot(game.match, -1.6, -0.3)
    test.expect(test.state_hash() ~= fresh)
    test.press("r")
    test.run(1)
    test.release("r")
    test.run(29)
    test.expect_equal(test.state_hash(), fresh)
end)

test.test("keys aim and shoot, P holds everything still", function()
    test.start{}
    local match = require("src.game").match
    test.press("left")
    test.run(20)
    test.release("left")
    test.run(1)
    test.expect(match.slingshot:pull() > 1)
    test.press("p")
    test.run(1)
    local before = test.state_hash()
    test.run(20)
    test.expect_equal(test.state_hash(), before)
    test.release("p")
    test.press("p")
    test.run(1)
    test.press("space")
    test.run(1)
    test.expect_equal(match.phase, "flying")
    test.expect_equal(match.shots_left, match.level.shots - 1)
end)

test.test("a drag with the mouse shoots, and a click beside the pebble does not", function()
    test.start{}
    local match = require("src.game").match
    test.run(5)
    local x, y = match.view.camera:to_screen(match.slingshot:pouch())
    test.mouse_press(x + 200, y)
    test.run(1)
    test.mouse_release(x + 200, y)
    test.run(1)
    test.expect_equal(match.phase, "aiming")
    test.mouse_press(x, y)
    test.run(1)
    test.mouse_move(x - 90, y + 20)
    test.run(1)
    test.expect_near(match.slingshot.pull_x, -90 * match.level.view.height / 720, 1e-4)
    test.mouse_release(x - 90, y + 20)
    test.run(1)
    test.expect_equal(match.phase, "flying")
end)

test.test("a pause during a drag puts the pebble back", function()
    test.start{}
    local match = require("src.game").match
    test.run(5)
    local x, y = match.view.camera:to_screen(match.slingshot:pouch())
    test.mouse_press(x, y)
    test.mouse_move(x - 90, y + 20)
    test.run(1)
    test.expect(match.slingshot:pull() > 1)
    test.press("p")
    test.run(1)
    test.release("p")
    test.mouse_release(x - 90, y + 20)
    test.press("p")
    test.run(1)
    test.mouse_move(x - 200, y)
    test.run(1)
    test.expect_equal(match.slingshot:pull(), 0)
    test.expect_equal(match.phase, "aiming")
end)

test.test("the recorded run wins", function()
    local result = test.play_replay("replays/level-01.replay")
    test.expect_equal(result.outcome, "won")
    test.expect_equal(result.level, "level-01")
    test.expect(result.stars >= 1)
end)
