-- The games on the shelf: which there are, which one is chosen, and where each card stands.
local shelf = {}

local COLUMNS = 3
local CARD_WIDTH, CARD_HEIGHT, GAP = 352, 250, 32
local LEFT, TOP = 80, 136

-- A game is a folder with main.lua, at the root or one level below it.
local function find_games()
    local games = {}
    local function look(folder)
        if not cairn.files.exists(folder .. "/main.lua") then
            return false
        end
        local title
        local ok, conf = pcall(cairn.files.read_data, folder .. "/conf.lua")
        if ok then
            title = conf.title
        end
        games[#games + 1] = { folder = folder, title = title or folder:match("[^/]+$") }
        return true
    end
    for _, name in ipairs(cairn.files.list("")) do
        if name ~= "tests" and name ~= "save" and cairn.files.is_folder(name) and not look(name) then
            for _, inner in ipairs(cairn.files.list(name)) do
                if cairn.files.is_folder(name .. "/" .. inner) then
                    look(name .. "/" .. inner)
                end
            end
        end
    end
    return games
end

function shelf.new(games)
    return { games = games or find_games(), chosen = 1, scroll = 0 }
end

-- The card of a game on the screen: x, y, width, height.
function shelf.card(self, index)
    local column, row = (index - 1) % COLUMNS, (index - 1) // COLUMNS
    return LEFT + column * (CARD_WIDTH + GAP), TOP + row * (CARD_HEIGHT + GAP) - self.scroll, CARD_WIDTH, CARD_HEIGHT
end

-- The game whose card lies at a point, or nil.
function shelf.at(self, x, y)
    for index = 1, #self.games do
        local left, top, width, height = shelf.card(self, index)
        if x >= left and x < left + width and y >= top and y < top + height then
            return index
        end
    end
end

-- Moves the choice by columns and rows, and stays on the shelf.
function shelf.move(self, columns, rows)
    if #self.games > 0 then
        local index = self.chosen + columns + rows * COLUMNS
        if index >= 1 and index <= #self.games then
            self.chosen = index
        elseif rows > 0 and (self.chosen - 1) // COLUMNS < (#self.games - 1) // COLUMNS then
            self.chosen = #self.games -- the last row is not full
        end
    end
end

-- Scrolls so that the chosen card can be seen whole; a share of the way in each update.
function shelf.update(self, screen_height)
    local _, top, _, height = shelf.card(self, self.chosen)
    local wanted = self.scroll
    if top < TOP then
        wanted = self.scroll - (TOP - top)
    elseif top + height > screen_height - 72 then
        wanted = self.scroll + top + height - (screen_height - 72)
    end
    self.scroll = self.scroll + 0.25 * (math.max(wanted, 0) - self.scroll)
end

return shelf
