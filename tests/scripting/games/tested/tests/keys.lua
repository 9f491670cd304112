local test = cairn.test

test.test("two presses win", function()
    test.start{}
    test.press("space")
    test.run(1)
    test.expect_equal(test.result(), nil)
    test.press("space")
    test.expect(test.run_until(function() return test.result() ~= nil end, 5))
    test.expect_equal(test.result().score, 2)
end)

test.test("each test has a state of its own", function()
    test.start{}
    test.press("space")
    test.run(2)
    test.expect_equal(test.result(), nil)
    test.expect_near(cairn.timer.time(), 2 / 60, 1e-9)
    test.expect_error(function() test.press("sapce") end, "key")
end)
