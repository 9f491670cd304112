local test = cairn.test
local shelf = require("shelf")

local function shelf_of(count)
    local games = {}
    for i = 1, count do
        games[i] = { folder = "game" .. i, title = "Game " .. i }
    end
    return shelf.new(games)
end

test.test("the choice stays on the shelf", function()
    local four = shelf_of(4)
    shelf.move(four, -1, 0)
    test.expect_equal(four.chosen, 1)
    shelf.move(four, 1, 0)
    test.expect_equal(four.chosen, 2)
    shelf.move(four, 0, 1) -- nothing stands below: the last row's last card is the nearest
    test.expect_equal(four.chosen, 4)
    shelf.move(four, 0, 1)
    test.expect_equal(four.chosen, 4)
    shelf.move(four, 0, -1)
    test.expect_equal(four.chosen, 1)
end)

test.test("the card under a point is the one that is drawn there", function()
    local seven = shelf_of(7)
    for index = 1, 7 do
        local x, y, width, height = shelf.card(seven, index)
        test.expect_equal(shelf.at(seven, x + width / 2, y + height / 2), index)
        test.expect_equal(shelf.at(seven, x - 1, y + height / 2), nil)
    end
end)

test.test("it scrolls until the chosen card can be seen", function()
    local many = shelf_of(12)
    many.chosen = 12
    for _ = 1, 120 do
        shelf.update(many, 720)
    end
    local _, top, _, height = shelf.card(many, 12)
    test.expect(top > 136 and top + height < 720 - 71)
    many.chosen = 1
    for _ = 1, 120 do
        shelf.update(many, 720)
    end
    test.expect_near(many.scroll, 0, 1)
end)

test.test("without games it says so and plays nothing", function()
    test.start{}
    test.press("return")
    test.run(2)
    test.expect_equal(test.result(), nil)
end)
