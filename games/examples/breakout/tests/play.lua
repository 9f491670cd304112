-- Run with `cairn test games/examples/breakout`.
local test = cairn.test

-- Keeps the mouse below the ball, a little beside it, so that the ball goes everywhere.
local function follow_ball(frame)
    local ball = breakout.ball
    if not ball:is_valid() then return end
    local x = ball:position() + 0.8 * math.sin(frame / 37)
    test.mouse_move(480 + x * 60, 650)
end

test.test("whoever follows the ball breaks every brick, and what breaks falls out of the box", function()
    test.start{}
    test.mouse_press(480, 600)
    test.run(1)
    test.mouse_release(480, 600)
    local frame = 0
    local is_over = test.run_until(function()
        frame = frame + 1
        follow_ball(frame)
        if not breakout.is_served and frame % 20 == 0 then test.press("space") end
        if frame % 20 == 10 then test.release("space") end
        return breakout.outcome ~= nil
    end, 60 * 300)
    test.expect(is_over, "the wall still stands after five minutes")
    test.expect_equal(breakout.outcome, "won")
    test.expect_equal(test.result().score, 8 * (50 + 40 + 30 + 20 + 10))
end)

test.test("three balls let fall are a game lost", function()
    test.start{}
    test.mouse_move(20, 600) -- the paddle stays in its corner
    for _ = 1, 3 do
        test.press("space")
        test.run(1)
        test.release("space")
        test.mouse_move(20, 600)
        test.run(600)
        test.mouse_move(940, 600)
        test.run(600)
    end
    test.run_until(function() return breakout.outcome ~= nil end, 60 * 60)
    test.expect(breakout.lives < 3)
end)

test.test("the ball keeps its speed and stays in the box", function()
    test.start{}
    test.gamepad_connect(1)
    test.gamepad_press(1, "a")
    test.run(30)
    for _ = 1, 10 do
        test.run(6)
        if breakout.is_served then
            local vx, vy = breakout.ball:linear_velocity()
            test.expect_near(math.sqrt(vx * vx + vy * vy), 9, 0.01)
            local x, y = breakout.ball:position()
            test.expect(math.abs(x) < 7.5 and y < 11.2)
        end
    end
end)
