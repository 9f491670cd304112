-- Points and stars.
-- Invariant: points are whole numbers, and the sum only grows while a match lasts.

local score = {}

score.GRUMP = 5000
score.SPARE_SHOT = 3000

-- Points are given in these steps, so that they read well.
local STEP = 10

--- For breaking a piece: the bigger, the more.
function score.piece(points_per_square_metre, area)
    return math.max(STEP, math.floor(points_per_square_metre * area / STEP + 0.5) * STEP)
end

--- For the shots that were not needed.
function score.bonus(spare_shots)
    return spare_shots * score.SPARE_SHOT
end

--- Stars of a match that was won: `thresholds` has the points for `two` and for `three`.
function score.stars(points, thresholds)
    if points >= thresholds.three then
        return 3
    elseif points >= thresholds.two then
        return 2
    end
    return 1
end

return score
