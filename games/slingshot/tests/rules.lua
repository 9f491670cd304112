-- The rules by themselves: damage, points, the pull of the slingshot.

local test = cairn.test

test.test("an impulse below the threshold leaves no mark, and one of the full strength breaks", function()
    local damage = require "src.damage"
    local strength = 20
    test.expect_equal(damage.share(0, strength), 0)
    test.expect_equal(damage.share(damage.THRESHOLD * strength, strength), 0)
    test.expect(damage.share(damage.THRESHOLD * strength + 0.01, strength) > 0)
    test.expect_near(damage.share(strength * (1 + damage.THRESHOLD) / 2, strength), 0.5, 1e-9)
    test.expect_equal(damage.share(strength, strength), 1)
    test.expect_equal(damage.share(50 * strength, strength), 1)
end)

test.test("health falls from blow to blow until the thing breaks, once", function()
    local damage = require "src.damage"
    local thing = { health = 1, strength = 10 }
    local impulse = 3 + 7 * 0.4
    test.expect(not damage.strike(thing, impulse))
    test.expect_near(thing.health, 0.6, 1e-9)
    test.expect(not damage.strike(thing, impulse))
    test.expect(damage.strike(thing, impulse))
    test.expect_equal(thing.health, 0)
    test.expect(not damage.strike(thing, impulse))
end)

test.test("a piece of four times the area takes twice the impulse", function()
    local damage = require "src.damage"
    test.expect_near(damage.strength(13, 4) / damage.strength(13, 1), 2, 1e-9)
end)

test.test("damage shows in four states that only go up as health goes down", function()
    local damage = require "src.damage"
    test.expect_equal(damage.state(1), 0)
    local last = 0
    for percent = 100, 0, -1 do
        local state = damage.state(percent / 100)
        test.expect(state == last or state == last + 1)
        last = state
    end
    test.expect_equal(last, 3)
end)

test.test("points: pieces by area in steps of ten, spare pebbles 3000 each, stars by the level's thresholds", function()
    local score = require "src.score"
    test.expect_equal(score.piece(600, 0.5), 300)
    test.expect_equal(score.piece(600, 0.748), 450)
    test.expect_equal(score.piece(600, 0.0001), 10)
    test.expect_equal(score.bonus(0), 0)
    test.expect_equal(score.bonus(2), 6000)
    local thresholds = { two = 8000, three = 12000 }
    test.expect_equal(score.stars(0, thresholds), 1)
    test.expect_equal(score.stars(7999, thresholds), 1)
    test.expect_equal(score.stars(8000, thresholds), 2)
    test.expect_equal(score.stars(11999, thresholds), 2)
    test.expect_equal(score.stars(12000, thresholds), 3)
end)

test.test("the band reaches no farther than its length and not into the ground", function()
    local slingshot = require "src.slingshot"
    local sling = slingshot.new(3)
    sling:set_pull(-30, 40)
    test.expect_near(sling:pull(), slingshot.REACH, 1e-9)
    test.expect_near(sling.pull_y / sling.pull_x, -4 / 3, 1e-9)
    local vx, vy = sling:velocity()
    test.expect_near(math.sqrt(vx * vx + vy * vy), slingshot.TOP_SPEED, 1e-9)
    sling:set_pull(0, -30)
    local _, y = sling:pouch()
    test.expect(y >= slingshot.GROUND_CLEARANCE - 1e-9)
end)

test.test("the grabbed pebble keeps its distance from the mouse", function()
    local slingshot = require "src.slingshot"
    local sling = slingshot.new(0)
    test.expect(not sling:grab(1.5, slingshot.REST_HEIGHT))
    test.expect(sling:grab(0.3, slingshot.REST_HEIGHT - 0.2))
    sling:drag(-0.7, slingshot.REST_HEIGHT - 0.7)
    test.expect_near(sling.pull_x, -1.0, 1e-9)
    test.expect_near(sling.pull_y, -0.5, 1e-9)
end)

test.test("letting go of a band that is hardly pulled does not shoot", function()
    local slingshot = require "src.slingshot"
    local sling = slingshot.new(0)
    sling:set_pull(-0.9 * slingshot.LEAST_PULL, 0)
    test.expect(sling:release() == nil)
    sling:set_pull(-1.1 * slingshot.LEAST_PULL, 0)
    test.expect(sling:release() ~= nil)
    test.expect_equal(sling:pull(), 0)
end)

test.test("aiming with keys goes on from the last shot", function()
    local slingshot = require "src.slingshot"
    local sling = slingshot.new(0)
    sling:set_pull(-0.8, 0.3)
    sling:release()
    sling:update_keys(0, function(key) return key == "up" end)
    test.expect_equal(sling.held, "keys")
    test.expect_near(sling.pull_x, -0.8, 1e-6)
    test.expect_near(sling.pull_y, 0.3, 1e-6)
end)

test.test("the outline of a piece stays inside its corners and keeps nearly all of its area", function()
    local outline = require "src.outline"
    local corners = outline.corners("box", 2, 0.4)
    test.expect_near(outline.area(corners), 0.8, 1e-9)
    test.expect_near(outline.area(outline.corners("triangle", 1.3, 0.8)), 0.52, 1e-9)
    local flat = outline.rounded(corners, 0)
    local pairs_of = {}
    for i = 1, #flat, 2 do
        test.expect(math.abs(flat[i]) <= 1 + 1e-6 and math.abs(flat[i + 1]) <= 0.2 + 1e-6)
        pairs_of[#pairs_of + 1] = { flat[i], flat[i + 1] }
    end
    -- Each corner loses a square of the radius less a quarter disc of three chords: 0.07^2 (1 - 0.75).
    test.expect_near(outline.area(pairs_of), 0.8 - 4 * 0.0049 * 0.25, 1e-4)
end)
