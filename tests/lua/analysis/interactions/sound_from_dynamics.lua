-- The length of the surface's bumps (m): a table of C++ that no property shows.
local bumps = {
  steel = 0.001, iron = 0.002, copper = 0.001, wood = 0.003, glass = 0.0005, rubber = 0.002, stone = 0.004,
  plastic = 0.001, brick = 0.005, water = 0.01, gold = 0.001,
}
-- Areas (m^2) and centres (m) of shapes, term by term in the order of massPropertiesOf().
local function ofPolygon(corners)
  local origin = corners[1]
  local area, centre = 0, vec2(0, 0)
  for i = 2, #corners - 1 do
    local p, q = corners[i] - origin, corners[i + 1] - origin
    local part = p:cross(q) / 2
    area = area + part
    centre = centre + part / 3 * (p + q)
  end
  return area, centre * (1 / area) + origin
end
local function inOwnFrame(piece)
  local radius = piece.radius
  if piece.form == "circle" then
    return math.pi * radius * radius, vec2(0, 0)
  elseif piece.form == "box" then
    return piece.width * piece.height, vec2(0, 0)
  elseif piece.form == "capsule" then
    return 4 * (piece.width / 2 - radius) * radius + math.pi * radius * radius, vec2(0, 0)
  end
  return ofPolygon(piece.corners)
end
local function centreOf(pieces)
  if #pieces == 1 and pieces[1].at == vec2(0, 0) and pieces[1].angle_deg == 0 then
    local _, centre = inOwnFrame(pieces[1])
    return centre
  end
  local area, centre = 0, vec2(0, 0)
  for _, piece in ipairs(pieces) do
    local own, middle = inOwnFrame(piece)
    area = area + own
    centre = centre + own * (piece.at + middle:turned(piece.angle_deg))
  end
  return centre * (1 / area)
end
local function roundness(pieces)
  local round = 0
  for _, piece in ipairs(pieces) do
    if piece.form ~= "circle" and piece.form ~= "capsule" then
      return 0
    end
    round = math.max(round, piece.radius)
  end
  return round
end

-- What is read of an object, once for each contact, as a script does not know which objects it has met.
local function seen(handle)
  local body = { handle = handle, movable = false, round = 0, angle = 0, at = vec2(0, 0), spin = 0,
    friction = 0.5, bump = bumps.plastic, sounds = false }
  if not alive(handle) then
    return body
  end
  local material, mass, shape = handle.material, handle.mass, handle.shape
  local angle, at, spin = handle.Rotation, handle.Position, handle["Angular Velocity"]
  local friction = handle.friction
  body.sounds = material ~= nil or handle.acoustics ~= nil
  body.bump = material and bumps[material.value] or body.bump
  body.movable = mass ~= nil and not handle.fixed
  body.shape, body.round = shape, shape and roundness(shape.value) or 0
  body.angle, body.at = angle and angle.value or 0, at and at.value or body.at
  body.spin, body.velocity = spin and spin.value or 0, handle.velocity
  body.friction = friction and friction.value or body.friction
  return body
end
local function quarter(v)
  return vec2(-v.y, v.x)
end
local function velocityAt(body, point)
  if not (body.velocity and body.shape) then
    return vec2(0, 0)
  end
  local centre = body.at + centreOf(body.shape.value):turned(body.angle)
  return body.velocity.value + body.spin * quarter(point - centre)
end
local function strike(out, body, other, impact, normal)
  if body.sounds then
    out.strike{ object = body.handle, other = other.handle, point = (impact.point - body.at):turned(-body.angle),
      normal = normal:turned(-body.angle), impulse = impact.impulse, since = impact.since }
  end
  local sample = alive(body.handle) and body.handle.sample
  if sample and sample.cue == "struck" then
    local share = math.min(1, impact.impulse / sample.full_impulse)
    out.playSample(body.handle, share * share)
  end
end
local function rub(out, body, other, point, normal, force, bandwidth)
  if body.sounds then
    out.rub(body.handle, other.handle, (point - body.at):turned(-body.angle), normal:turned(-body.angle), force,
      bandwidth)
  end
end
local function rubbing(out, patch, load)
  local a, b = seen(patch.a), seen(patch.b)
  local point = patch.count > 1 and 0.5 * (patch.point + patch.second_point) or patch.point
  local relative = velocityAt(b, point) - velocityAt(a, point)
  local slip = math.abs(relative:dot(quarter(patch.normal)))
  local rolling = math.abs(b.spin - a.spin) * math.max(a.round, b.round)
  local speed = slip > 0.02 and slip or rolling
  if not (speed > 0.02) then
    return
  end
  local force = slip > 0.02 and 0.1 * math.sqrt(a.friction * b.friction) * load or 0.03 * load
  if force > 1e-4 then
    local bandwidth = speed / math.max(a.bump, b.bump)
    rub(out, a, b, point, -patch.normal, force, bandwidth)
    rub(out, b, a, point, patch.normal, force, bandwidth)
  end
end

return interaction {
  name = "Sound <- Dynamics",
  text = "Excites both objects of every impact, and objects that slide or roll on each other; plays the recordings of "
    .. "struck objects.",
  calls = "Sound",
  reads = { "impacts", "contact_patches", "contacts", "shape", "material", "acoustics", "sample", "mass", "fixed",
    "friction", "Position", "Rotation", "velocity", "Angular Velocity" },
  once = true,
  limits = { instructions = 200000, calls = 1000 },
  apply = function(world, params, out)
    for _, impact in ipairs(world.impacts.impacts) do
      local a, b = seen(impact.a), seen(impact.b)
      if (a.movable or b.movable) and impact.impulse > 0 then
        strike(out, a, b, impact, -impact.normal)
        strike(out, b, a, impact, impact.normal)
      end
    end
    local patches = world.contact_patches
    local step = patches.step
    if not (step > 0) then
      return
    end
    for _, patch in ipairs(patches.patches) do
      local load = (patch.impulse + (patch.count > 1 and patch.second_impulse or 0)) / step
      if load > 1e-4 then
        rubbing(out, patch, load)
      end
    end
  end,
}
