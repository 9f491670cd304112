-- For `cairn check slingshot`: the faults of all levels.

local level = require "src.level"

local faults = {}
for _, name in ipairs(cairn.files.list("levels")) do
    local id = name:match("^(.+)%.lua$")
    if id then
        local is_good, message = pcall(level.load, id)
        if not is_good then
            faults[#faults + 1] = message
        end
    end
end
return faults
