-- A free kick over a wall with LÖVE 11 and the C library. Aim with the mouse or the arrow keys. A and D change the sidespin, W and S the topspin.
-- Hold the mouse button or the space bar for power, and release it to kick. R resets the ball.
--   love samples/Love                        play
--   love samples/Love --picture FILE.png     kick once, write a picture and print: Goal! hash 44123208c9f0f689
local ffi, bit, draw, STEP, GOAL, WALL, FOCAL, HORIZON = require("ffi"), require("bit"), love.graphics, 1 / 60, -22, -9.15, 1000, 170
if arg[2] == "--picture" then love.errorhandler = print end

-- The folder that build.sh of src/Football.Physics.Native wrote. LuaJIT parses the header, but has no preprocessor, so the code below replaces the macros.
local prefix = os.getenv("FOOTBALL_PHYSICS") or love.filesystem.getSource() .. "/../../out/native"
local header, macros = assert(io.open(prefix .. "/include/football_physics.h")):read("*a"):gsub("#ifdef __cplusplus.-#endif", ""), {}
for name, value in header:gmatch("#define (FOOTBALL_%u+_%u+) (%d+)") do macros[name] = tonumber(value) end
ffi.cdef((header:gsub("#[^\n]*", ""):gsub("FOOTBALL_API ", ""):gsub("FOOTBALL_%u+_%u+", macros)))
local C = ffi.load(prefix .. (({ Windows = "/bin/football_physics.dll", OSX = "/lib/libfootball_physics.dylib" })[ffi.os] or "/lib/libfootball_physics.so"))
local function check(status) return status == C.FP_OK or error(ffi.string(C.fp_last_error()), 2) end
check(C.fp_check_abi(macros.FOOTBALL_ABI_VERSION, ffi.sizeof("fp_state"), ffi.sizeof("fp_ball"), ffi.sizeof("fp_event")))
local pitch = [[{"goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}],
  "obstacles": [{"name": "wall", "shape": "box", "center": [1, 0.92, -9.15], "halfSize": [1.3, 0.92, 0.2]}]}]]
local scene, state, ball, events, count = ffi.new("fp_scene *[1]"), ffi.new("fp_state"), ffi.new("fp_ball"), ffi.new("fp_event[16]"), ffi.new("int32_t[1]")
local spot, velocity, spin, path, rows, name = ffi.new("double[3]", 0, 0.11, 0), ffi.new("double[3]"), ffi.new("double[3]"), ffi.new("double[50][4]"), ffi.new("int64_t[1]"), ffi.new("char[32]")
check(C.fp_scene_create(pitch, #pitch, scene))
local eye, target, side, top, trail, flying, kicks, goals, text, held, left = { 0, 2.8, 8.5 }, { 2.9, 1.7 }, -45, 0, {}, false, 0, 0, "", nil, 0

local function place()
  check(C.fp_launch(scene[0], spot, ffi.new("double[3]"), ffi.new("double[3]"), state))
  check(C.fp_read(scene[0], state, ball))
  flying, held, trail, text = false, nil, {}, "Aim, hold for power, let go to kick."
end

local function kick(which, speed)
  local request = ('{"from": [0, 0.11, 0], "target": [%.17g, %.17g, -22], "speed": %.17g, "spin": {"side": %.17g, "top": %.17g}}'):format(target[1], target[2], speed, side, top)
  check(C.fp_aim(scene[0], request, #request, velocity, spin, nil, nil))
  check(C.fp_kick(scene[0], which, velocity, spin))
end

local function shoot(speed)
  kick(state, speed)
  flying, held, kicks, text = true, nil, kicks + 1, ("%.0f km/h"):format(speed * 3.6)
end

local function step()
  check(C.fp_step(scene[0], state, STEP, events, 16, count))
  check(C.fp_read(scene[0], state, ball))
  for i = 0, count[0] - 1 do
    check(C.fp_name(scene[0], events[i].thing, name, 32))
    if events[i].kind == C.FP_EVENT_GOAL then goals, text = goals + 1, "Goal!" end
    if events[i].kind == C.FP_EVENT_IMPACT and ffi.string(name) ~= "ground" then text = "Hit the " .. ffi.string(name) .. "." end
  end
  if flying and ball.position[2] > GOAL - 2 and #trail < 300 then for k = 0, 2 do trail[#trail + 1] = ball.position[k] end end
end

local function power() return 16 + 16 * math.min(1, held and love.timer.getTime() - held or 0.5) end
local function seen(x, y, z) -- returns the pixel of a point, and the pixels of a metre there
  local scale = FOCAL / math.max(0.5, eye[3] - z)
  return 480 + scale * (x - eye[1]), HORIZON - scale * (y - eye[2]), scale
end

local function disc(color, x, y, z, radius, flat)
  local u, v, scale = seen(x, y, z)
  draw.setColor(color)
  draw.ellipse("fill", u, v, radius * scale, radius * scale * (flat or 1))
end

local function shape(color, width, ...) -- draws through points x, y, z; without a width, filled
  local points, pixels = type(...) == "table" and ... or { ... }, {}
  for i = 1, #points, 3 do pixels[#pixels + 1], pixels[#pixels + 2] = seen(points[i], points[i + 1], points[i + 2]) end
  draw.setColor(color)
  if not width then return draw.polygon("fill", pixels) end
  draw.setLineWidth(width)
  draw.line(pixels)
end
local function box(color, z, x1, x2, y1, y2) shape(color, nil, x1, y1, z, x2, y1, z, x2, y2, z, x1, y2, z) end
local function flat(color, x1, z1, x2, z2) shape(color, nil, x1, 0, z1, x2, 0, z1, x2, 0, z2, x1, 0, z2) end

local function draw_ball()
  local p, q = ball.position, ball.orientation
  disc({ 0.05, 0.2, 0.05, 0.6 }, p[0], 0, p[2], 0.13, 0.25)
  disc({ 0.98, 0.98, 0.98 }, p[0], p[1], p[2], 0.11)
  for i = 0, 11 do -- the patches: corners of an icosahedron, turned by the ball's quaternion
    local c = { [i % 3] = 0, [(i + 1) % 3] = i < 6 and 0.53 or -0.53, [(i + 2) % 3] = i % 6 < 3 and 0.85 or -0.85 }
    local tx, ty, tz = 2 * (q[1] * c[2] - q[2] * c[1]), 2 * (q[2] * c[0] - q[0] * c[2]), 2 * (q[0] * c[1] - q[1] * c[0])
    local x, y, z = c[0] + q[3] * tx + q[1] * tz - q[2] * ty, c[1] + q[3] * ty + q[2] * tx - q[0] * tz, c[2] + q[3] * tz + q[0] * ty - q[1] * tx
    if z > 0.2 then disc({ 0.1, 0.1, 0.15 }, p[0] + 0.09 * x, p[1] + 0.09 * y, p[2], 0.035 * z) end
  end
end

function love.draw()
  eye[1], eye[3] = 0.15 * ball.position[0], 8.5 + 0.4 * math.max(GOAL, ball.position[2])
  draw.clear(0.55, 0.74, 0.92)
  box({ 0.16, 0.19, 0.27 }, -34, -50, 50, 0, 7)
  for i = 0, 1499 do disc({ 0.35 + i * 7 % 5 * 0.13, 0.3 + i * 3 % 7 * 0.08, 0.35 + i * 5 % 4 * 0.14 }, -30 + i * 59.95 % 60, 1.4 + i % 10 * 0.55 + i * 0.37 % 0.2, -34, 0.13) end
  for x = -36, 30, 6 do box(x % 12 == 0 and { 0.1, 0.3, 0.6 } or { 0.95, 0.75, 0.2 }, -28, x, x + 6, 0, 0.9) end
  for z = -28, 4, 4 do flat(z % 8 == 0 and { 0.25, 0.55, 0.24 } or { 0.29, 0.61, 0.27 }, -60, z, 60, z + 4) end
  for _, x in ipairs({ -9.16, 9.16 }) do flat({ 0.9, 0.95, 0.9 }, x - 0.06, -22, x + 0.06, -16.5) end
  for _, z in ipairs({ -22, -16.5, -5.5 }) do flat({ 0.9, 0.95, 0.9 }, z == -16.5 and -9.16 or -40, z - 0.06, z == -16.5 and 9.16 or 40, z + 0.06) end
  for x = -3.72, 3.73, 0.372 do shape({ 1, 1, 1, 0.4 }, 1, x, 2.5, -22, x, 2.5, -22.8, x, 0, -24) end
  for y = 0, 2.5, 0.3125 do shape({ 1, 1, 1, 0.4 }, 1, -3.72, y, -22, -3.72, y, -24 + 0.48 * y, 3.72, y, -24 + 0.48 * y, 3.72, y, -22) end
  shape({ 1, 1, 1 }, 5, -3.72, 0, -22, -3.72, 2.5, -22, 3.72, 2.5, -22, 3.72, 0, -22)
  if ball.position[2] < WALL then draw_ball() end
  for x = -0.04, 2.05, 0.52 do -- the wall of players
    disc({ 0.1, 0.35, 0.1 }, x, 0, WALL, 0.32, 0.15)
    for leg = x - 0.18, x + 0.05, 0.22 do box({ 0.95, 0.95, 0.95 }, WALL, leg, leg + 0.14, 0, 0.62) end
    box({ 0.12, 0.14, 0.3 }, WALL, x - 0.21, x + 0.21, 0.52, 0.98)
    box({ 0.8, 0.14, 0.2 }, WALL, x - 0.24, x + 0.24, 0.92, 1.55)
    disc({ 0.25, 0.16, 0.1 }, x, 1.71, WALL, 0.13)
    disc({ 0.9, 0.7, 0.55 }, x, 1.67, WALL, 0.11)
  end
  if #trail > 3 then shape({ 1, 0.93, 0.4, 0.9 }, 2, trail) end
  if ball.position[2] >= WALL then draw_ball() end
  for i = 0, flying and -1 or tonumber(rows[0]) - 1 do disc({ 1, 1, 1, 0.8 }, path[i][1], path[i][2], path[i][3], 0.035) end
  draw.setColor(0.08, 0.1, 0.2)
  draw.print(("%s    Goals: %d of %d    Sidespin %.0f, topspin %.0f rad/s"):format(text, goals, kicks, side, top), 16, 9)
  draw.rectangle("fill", 780, 14, 160 * (power() - 16) / 16, 12)
end

function love.update(dt)
  local function axis(less, more) return dt * ((love.keyboard.isDown(more) and 1 or 0) - (love.keyboard.isDown(less) and 1 or 0)) end
  target = { target[1] + 3 * axis("left", "right"), math.max(0.11, target[2] + 3 * axis("down", "up")) }
  side, top = math.max(-80, math.min(80, side + 60 * axis("d", "a"))), math.max(-60, math.min(60, top + 60 * axis("s", "w")))
  if not flying then
    local trial = ffi.new("fp_state", state)
    kick(trial, power())
    check(C.fp_look_ahead(scene[0], trial, 1.2, 0.04, path[0], 50, rows))
  end
  left = math.min(left + dt, 0.1)
  while left >= STEP do left = left - STEP step() end
end

function love.mousemoved(u, v) target = { (u - 480) * 30.5 / FOCAL, math.max(0.11, eye[2] - (v - HORIZON) * 30.5 / FOCAL) } end
function love.mousepressed() place() held = love.timer.getTime() end
function love.mousereleased() if held then shoot(power()) end end
function love.keypressed(key) if key == "space" then love.mousepressed() elseif key == "r" then place() end end
function love.keyreleased(key) if key == "space" then love.mousereleased() end end

function love.load(arguments)
  draw.setNewFont(18)
  place()
  if arguments[1] ~= "--picture" then return end
  shoot(24)
  for _ = 1, 73 do step() end
  love.update = nil
  draw.captureScreenshot(function(picture)
    assert(io.open(arguments[2], "wb")):write(picture:encode("png"):getString())
    for _ = 74, 240 do step() end
    print(text .. " hash " .. bit.tohex(C.fp_hash(state)))
    love.event.quit()
  end)
end
