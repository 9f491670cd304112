-- The slingshot: how far and where to the band is pulled, and what speed that gives.
-- Invariant: the pull never exceeds REACH and never takes the pebble into the ground.
-- A pebble flies freely from where it is let go, and the engine's free flight is exact, so the preview is the parabola.

local slingshot = {}
slingshot.__index = slingshot

slingshot.REST_HEIGHT = 2.15         -- of the pebble above the ground, m
slingshot.REACH = 1.7                -- longest pull, m
slingshot.TOP_SPEED = 17             -- at the longest pull, m/s
slingshot.LEAST_PULL = 0.3           -- letting go of less puts the pebble back, m
slingshot.GRAB_RADIUS = 1.0          -- around the pebble, m
slingshot.GROUND_CLEARANCE = 0.45    -- of the pulled pebble's centre, m

local KEY_TURN = 0.9                 -- radians per second
local KEY_PULL = 1.3                 -- metres per second

function slingshot.new(x)
    return setmetatable({
        x = x,
        y = slingshot.REST_HEIGHT,
        pull_x = 0,
        pull_y = 0,
        held = nil,                  -- "mouse" or "keys" while somebody aims
        grab_x = 0,                  -- from the mouse to the pebble when it was grabbed
        grab_y = 0,
        last_x = -1.3,               -- the pull of the last shot: aiming with keys goes on from there
        last_y = -0.4,
    }, slingshot)
end

--- Where the pebble is.
function slingshot:pouch()
    return self.x + self.pull_x, self.y + self.pull_y
end

function slingshot:pull()
    return math.sqrt(self.pull_x * self.pull_x + self.pull_y * self.pull_y)
end

--- Pulls as far towards the offset (dx, dy) from the place of rest as the band and the ground allow.
function slingshot:set_pull(dx, dy)
    local lowest = slingshot.GROUND_CLEARANCE - self.y
    local length = math.sqrt(dx * dx + dy * dy)
    if length > slingshot.REACH then
        dx, dy = dx * slingshot.REACH / length, dy * slingshot.REACH / length
    end
    self.pull_x, self.pull_y = dx, math.max(dy, lowest)
end

--- Takes hold of the pebble at a place in the world; false if that place is too far from it.
function slingshot:grab(x, y)
    local px, py = self:pouch()
    local dx, dy = px - x, py - y
    if dx * dx + dy * dy > slingshot.GRAB_RADIUS * slingshot.GRAB_RADIUS then
        return false
    end
    self.held = "mouse"
    self.grab_x, self.grab_y = dx, dy
    return true
end

function slingshot:drag(x, y)
    if self.held == "mouse" then
        self:set_pull(x + self.grab_x - self.x, y + self.grab_y - self.y)
    end
end

--- Puts the pebble back if the mouse holds it.
function slingshot:drop()
    if self.held == "mouse" then
        self.pull_x, self.pull_y, self.held = 0, 0, nil
    end
end

--- One update of aiming with the arrow keys: up and down turn, left and right pull and slacken.
function slingshot:update_keys(dt, is_down)
    local turn = (is_down("up") and 1 or 0) - (is_down("down") and 1 or 0)
    local pull = (is_down("left") and 1 or 0) - (is_down("right") and 1 or 0)
    if self.held == "mouse" or (turn == 0 and pull == 0) then
        return
    end
    if self.held ~= "keys" then
        self.held = "keys"
        if self:pull() < slingshot.LEAST_PULL then
            self:set_pull(self.last_x, self.last_y)
        end
    end
    local length = math.max(slingshot.LEAST_PULL, math.min(slingshot.REACH, self:pull() + pull * KEY_PULL * dt))
    local angle = math.atan(-self.pull_y, -self.pull_x) + turn * KEY_TURN * dt
    self:set_pull(-length * math.cos(angle), -length * math.sin(angle))
end

--- The velocity that letting go would give.
function slingshot:velocity()
    local k = slingshot.TOP_SPEED / slingshot.REACH
    return -self.pull_x * k, -self.pull_y * k
end

--- Lets go: place and velocity of the shot, or nothing if the pull is too short to shoot.
function slingshot:release()
    local x, y = self:pouch()
    local vx, vy = self:velocity()
    local enough = self:pull() >= slingshot.LEAST_PULL
    if enough then
        self.last_x, self.last_y = self.pull_x, self.pull_y
    end
    self.pull_x, self.pull_y, self.held = 0, 0, nil
    if enough then
        return x, y, vx, vy
    end
end

--- Calls visit(x, y, i) for the points of the flight that letting go would start, `interval` seconds apart, above the
--- ground.
function slingshot:preview(gravity_y, interval, count, visit)
    local x, y = self:pouch()
    local vx, vy = self:velocity()
    for i = 1, count do
        local t = i * interval
        local py = y + vy * t + 0.5 * gravity_y * t * t
        if py < 0 then
            return
        end
        visit(x + vx * t, py, i)
    end
end

return slingshot
