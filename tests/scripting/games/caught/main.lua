-- An endless loop that takes every error for its own.
function cairn.update()
    print("ready")
    while true do pcall(function() while true do end end) end
end
