-- A joint goes with the objects that it ties, and with the joints that it couples.
local function isBody(object)
  return alive(object) and object.shape ~= nil
end
local function isJoint(object)
  return alive(object) and object.joint ~= nil
end
local function isWhole(joint)
  return isBody(joint.a) and (joint.b == nil or isBody(joint.b))
    and (joint.form ~= "gear" or isJoint(joint.joint_a) and isJoint(joint.joint_b))
end

return interaction {
  name = "Population <- Dynamics",
  text = "Destroys every joint that was overloaded, and every one whose object no longer exists.",
  calls = "Population",
  reads = { "joint", "shape", "overloaded_joints" },
  each = { "joint" },
  apply = function(object, params, out)
    local overloaded = false
    for _, entry in ipairs(world.overloaded_joints.entries) do
      overloaded = overloaded or same(entry.object, object)
    end
    if overloaded or not isWhole(object.joint) then
      out.destroyObject(object)
    end
  end,
}
