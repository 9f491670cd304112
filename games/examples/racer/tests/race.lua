-- Run with `cairn test games/examples/racer`.
local test = cairn.test

test.test("the others finish their laps by themselves, and then the race is lost", function()
    test.start{}
    test.expect(test.run_until(function() return test.result() ~= nil end, 60 * 120), "nobody arrived in two minutes")
    test.expect_equal(test.result().outcome, "lost")
    for i = 2, 4 do test.expect_equal(race.cars[i].lap, 3) end
end)

test.test("the player's car does what the keys say", function()
    test.start{}
    local car = race.cars[1]
    test.press("up")
    test.run(60)
    test.expect(car.speed > 8)
    local before = car.body:angle()
    test.press("left")
    test.run(20)
    test.expect(car.body:angle() > before + 0.2)
    test.release("up")
    test.press("down")
    test.run(90)
    test.expect(car.speed < 0)
end)

test.test("a mouse that is held on the road ahead drives there, and a gamepad drives too", function()
    test.start{}
    local car = race.cars[1]
    test.mouse_press(640, 600)
    test.run(120)
    test.expect(car.speed > 5)
    test.expect(car.gate > 1)
    test.mouse_release(640, 600)
    test.gamepad_connect(1)
    test.gamepad_move(1, "left_trigger", 1)
    test.run(120)  -- the car behind pushes
    test.expect(car.speed < 1)
end)

test.test("the same race has the same end", function()
    test.start{}
    test.run(300)
    local text = test.recording()
    test.expect(text:find("frames 300", 1, true) ~= nil)
end)
