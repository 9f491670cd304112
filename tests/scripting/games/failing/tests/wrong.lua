cairn.test.test("one is two", function()
    cairn.test.expect_equal(1, 2)
end)
