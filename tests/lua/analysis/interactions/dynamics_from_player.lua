-- Area (m^2), centre (m) and square of the radius of gyration (m^2) of shapes: what C++ interactions ask the
-- function massPropertiesOf() for, term by term in the same order.
local function ofPolygon(corners)
  local origin = corners[1]
  local area, moment, centre = 0, 0, vec2(0, 0)
  for i = 2, #corners - 1 do
    local p, q = corners[i] - origin, corners[i + 1] - origin
    local part = p:cross(q) / 2
    area = area + part
    centre = centre + part / 3 * (p + q)
    moment = moment + part / 6 * (p:dot(p) + p:dot(q) + q:dot(q))
  end
  centre = centre * (1 / area)
  return area, centre + origin, moment / area - centre:dot(centre)
end
local function ofCapsule(width, radius)
  local half = width / 2 - radius
  local box = 4 * half * radius
  local disc = math.pi * radius * radius
  local offset = 4 * radius / (3 * math.pi)
  local boxMoment = box * (half * half + radius * radius) / 3
  local discMoment = disc * (radius * radius / 2 - offset * offset + (half + offset) * (half + offset))
  return box + disc, vec2(0, 0), (boxMoment + discMoment) / (box + disc)
end
local function inOwnFrame(piece)
  if piece.form == "circle" then
    return math.pi * piece.radius * piece.radius, vec2(0, 0), piece.radius * piece.radius / 2
  elseif piece.form == "box" then
    return piece.width * piece.height, vec2(0, 0),
      (piece.width * piece.width + piece.height * piece.height) / 12
  elseif piece.form == "capsule" then
    return ofCapsule(piece.width, piece.radius)
  end
  return ofPolygon(piece.corners)
end
local function massProperties(pieces)
  if #pieces == 1 and pieces[1].at == vec2(0, 0) and pieces[1].angle_deg == 0 then
    local _, centre, inertia = inOwnFrame(pieces[1])
    return centre, inertia
  end
  local area, centre, inertia = 0, vec2(0, 0), 0
  for _, piece in ipairs(pieces) do
    local own, middle = inOwnFrame(piece)
    area = area + own
    centre = centre + own * (piece.at + middle:turned(piece.angle_deg))
  end
  centre = centre * (1 / area)
  for _, piece in ipairs(pieces) do
    local own, middle, perMass = inOwnFrame(piece)
    local away = piece.at + middle:turned(piece.angle_deg) - centre
    inertia = inertia + own / area * (perMass + away:dot(away))
  end
  return centre, inertia
end

local frequency = 12 -- rad/s, of the spring
local usualStrength = 3000 -- N, of hands in a world that states none
local turnDamping = 2 -- 1/s

local function quarter(v)
  return vec2(-v.y, v.x)
end

-- The pull of one hand; `both`: the other hand holds the same object.
local function pull(world, hand, both, out)
  local held = hand.object
  if not alive(held) or held.fixed or not (held.shape and held.Position and held.Rotation and held.velocity
      and held["Angular Velocity"] and held.mass) or #held.shape.value == 0 then
    return
  end
  local centre, gyration = massProperties(held.shape.value)
  local angle, mass, spin = held.Rotation.value, held.mass.value, held["Angular Velocity"].value
  local point = held.Position.value + hand.local_point:turned(angle)
  local arm = (hand.local_point - centre):turned(angle)
  local pointVelocity = held.velocity.value + spin * quarter(arm)
  local wanted = frequency * frequency * (hand.target - point) - 2 * frequency * pointVelocity
  local across = quarter(arm)
  local force = mass * (wanted - across:dot(wanted) / (gyration + arm:dot(arm)) * across)
  local strength, size = world.hands and world.hands.strength or usualStrength, force:length()
  if strength <= 0 then
    return
  end
  if size > strength then
    force = force * (strength / size)
  end
  out.addForceToPoint(held, point, force)
  out.tellRate(held, both and math.sqrt(2) * frequency or frequency)
  out.addTorque(held, -turnDamping * mass * gyration * spin)
end

return interaction {
  name = "Dynamics <- Player",
  text = "Pulls the held point of each held object to where the hand is, like a critically damped spring, and "
    .. "damps its turning.",
  calls = "Dynamics",
  reads = { "hand", "second_hand", "hands", "Position", "Rotation", "velocity", "Angular Velocity", "mass", "shape",
    "fixed" },
  once = true,
  apply = function(world, params, out)
    local both = world.hand.object == world.second_hand.object
    pull(world, world.hand, both, out)
    pull(world, world.second_hand, both, out)
  end,
}
