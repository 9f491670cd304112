-- How impacts hurt.
-- Invariant: health goes from 1 down to 0 and never up. Mass counts, because what hurts is the impulse of the contact
-- (N s) and not the speed; it is weighed against the thing's strength, the impulse that breaks it at one blow.

local damage = {}

-- Impulses below this share of the strength leave no mark: a plank that slides off a wall is none the worse for it,
-- and a structure cannot be worn down by the small knocks of settling.
damage.THRESHOLD = 0.3

--- Which share of a full health an impulse takes.
function damage.share(impulse, strength)
    local threshold = damage.THRESHOLD * strength
    if impulse <= threshold then
        return 0
    end
    return math.min(1, (impulse - threshold) / (strength - threshold))
end

--- Strength of a body of that area: a bigger piece takes more, with its typical width rather than with its area, since
--- it breaks along a line.
function damage.strength(strength_per_metre, area)
    return strength_per_metre * math.sqrt(area)
end

--- Lets an impulse act on a thing with `health` and `strength`; says whether it broke just now.
function damage.strike(thing, impulse)
    if thing.health <= 0 then
        return false
    end
    thing.health = math.max(0, thing.health - damage.share(impulse, thing.strength))
    return thing.health == 0
end

--- 0 for a sound piece, then 1, 2, 3 as it weakens.
function damage.state(health)
    if health > 0.85 then
        return 0
    elseif health > 0.55 then
        return 1
    elseif health > 0.28 then
        return 2
    end
    return 3
end

return damage
